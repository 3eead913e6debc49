// Requests to and results of decoders of compressed glTF data.  Role: the interface between the reader and the
// decoders, which are native libraries or functions of the caller.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "hgp/io/document.h"

namespace hgp::io {

/// One buffer view to decode. The result must have exactly count · stride bytes.
struct MeshoptRequest {
  ByteView source;
  std::uint64_t count = 0, stride = 0;
  std::string mode;    ///< "ATTRIBUTES" "TRIANGLES" "INDICES"
  std::string filter;  ///< "NONE" "OCTAHEDRAL" "QUATERNION" "EXPONENTIAL"
};

/// One attribute to decode from a Draco mesh, tightly packed in `componentType`.
struct DracoAttribute {
  int uniqueId = 0;
  int componentType = 0;  ///< glTF's code: 5120 … 5126
  int components = 0;
};

struct DracoRequest {
  ByteView source;
  std::uint64_t vertexCount = 0,
                indexCount = 0;  ///< of the accessors; larger counts are refused
  std::vector<DracoAttribute> attributes;
};

/// Decoded triangles and one tightly packed array per requested attribute, in the order of the request.
struct DracoMesh {
  std::vector<std::uint32_t> indices;
  std::vector<Bytes> attributes;
};

/// An empty function means that this build has no such decoder; reading a file that needs it then fails with
/// kUnsupported.
struct GltfDecoders {
  std::function<Result<Bytes>(const MeshoptRequest&)> meshopt;
  std::function<Result<DracoMesh>(const DracoRequest&)> draco;
};

}  // namespace hgp::io
