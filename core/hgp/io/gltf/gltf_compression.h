// What decoders of compressed glTF data take and give.  Role: the interface between reading and
// whoever decodes.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "hgp/io/document.h"

namespace hgp::io {

/// One compressed buffer view. The result must have exactly count · stride bytes.
struct MeshoptRequest {
  ByteView source;
  std::uint64_t count = 0, stride = 0;
  std::string mode;    ///< "ATTRIBUTES" "TRIANGLES" "INDICES"
  std::string filter;  ///< "NONE" "OCTAHEDRAL" "QUATERNION" "EXPONENTIAL"
};

/// One attribute wanted of a Draco mesh, stored tightly in `componentType`.
struct DracoAttribute {
  int uniqueId = 0;
  int componentType = 0;  ///< of glTF: 5120 … 5126
  int components = 0;
};

struct DracoRequest {
  ByteView source;
  std::uint64_t vertexCount = 0,
                indexCount = 0;  ///< what the accessors say; never more is accepted
  std::vector<DracoAttribute> attributes;
};

/// Decoded triangles, and one tightly packed array per attribute asked for, in that order.
struct DracoMesh {
  std::vector<std::uint32_t> indices;
  std::vector<Bytes> attributes;
};

/// Empty functions: this build cannot decode that; reading then ends with kUnsupported, saying so.
struct GltfDecoders {
  std::function<Result<Bytes>(const MeshoptRequest&)> meshopt;
  std::function<Result<DracoMesh>(const DracoRequest&)> draco;
};

}  // namespace hgp::io
