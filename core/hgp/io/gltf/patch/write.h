// Writes a uv set as a lossless patch.  Role: edits the original text and appends to the original bytes;
// everything else stays as it was.
#pragma once

#include "hgp/io/document.h"
#include "hgp/io/gltf/decode/weld.h"
#include "hgp/io/gltf/patch/map.h"

namespace hgp::io {

/// One table (written vertex → stored vertex) determines every attribute, morph target, joint, weight and
/// colour: old vertices keep their indices, and copies at seams follow them. Accessors with other users
/// are cloned, indices get a wider type where needed, Draco primitives are stored uncompressed, missing lower
/// TEXCOORD sets are filled with the new uv, and TANGENT is removed if the uv of its normal map are replaced.
/// @pre `map` comes from roundToFloat32
Result<Written> writeGltf(const GltfStore& store, const GltfSurface& part, const UvMap& map,
                          const WriteOptions& options);

/// One map for each of several meshes; `notes` gets those on each.
Result<WrittenMaps> writeGltfMaps(const GltfStore& store, const std::vector<GltfMap>& maps,
                                  const WriteOptions& options);

}  // namespace hgp::io
