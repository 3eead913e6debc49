// A loaded and checked glTF asset: the text, the model and all bytes that they refer to.  Role: the source of
// surfaces, and the starting point of the patch writer.
#pragma once

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "hgp/io/document.h"
#include "hgp/io/gltf/decode/compression.h"
#include "hgp/io/gltf/json/file.h"
#include "hgp/io/gltf/json/model.h"

namespace hgp::io {

/// Where a buffer's bytes come from.
enum class GltfBufferKind { kBin, kData, kFile, kNone };

struct GltfBuffer {
  GltfBufferKind kind = GltfBufferKind::kNone;
  ByteView bytes;    ///< at least byteLength of them; empty for kNone
  Bytes owned;       ///< the storage of `bytes`, unless they are the BIN chunk
  std::string name;  ///< relative name of a kFile
};

/// One Draco primitive, decoded.
struct GltfDracoData {
  std::vector<std::uint32_t> indices;
  std::map<std::string, Bytes> attributes;  ///< semantic → tightly packed, in the accessor's type
};

struct GltfStore {
  std::string name;
  Bytes file;               ///< the GLB; empty for a .gltf, whose text is all in `json`
  GltfContainer container;  ///< of `file`
  JsonText json;
  GltfModel model;
  std::vector<GltfBuffer> buffers;
  std::map<int, Bytes> decodedViews;                          ///< meshopt views that meshes use
  std::map<std::pair<int, int>, GltfDracoData> decodedDraco;  ///< by mesh and primitive
  Notes notes;

  /// Bytes of a view; empty when they are compressed and no mesh needed them.
  ByteView viewBytes(int view) const;
  /// Bytes of an accessor from its first element, or empty without a view.
  ByteView accessorBytes(const GltfAccessor& accessor) const;
  /// Distance between consecutive elements, in bytes.
  std::uint64_t accessorStride(const GltfAccessor& accessor) const;
};

/// Opens, checks, resolves and decodes a file. Afterwards all data that a mesh refers to are safe to read.
Result<std::unique_ptr<GltfStore>> loadGltf(FileSet files, const Limits& limits,
                                            const GltfDecoders& decoders);

/// buffers.cpp: loads the bytes that every buffer declares.
Status loadGltfBuffers(GltfStore& store, const Resolver& resolve, const Limits& limits);
/// compressed.cpp: decodes what triangle primitives need.
Status decodeGltf(GltfStore& store, const GltfDecoders& decoders);
/// check_data.cpp: checks that indices and sparse indices are in range and that none is a restart value.
Status checkGltfData(const GltfStore& store);

}  // namespace hgp::io
