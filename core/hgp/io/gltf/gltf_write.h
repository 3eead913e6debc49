// The lossless patch: one more uv set, nothing else changed.  Role: splices the original text and
// appends to the original bytes.
#pragma once

#include "hgp/io/document.h"
#include "hgp/io/gltf/gltf_weld.h"

namespace hgp::io {

/// One xref (written vertex → stored vertex) drives every attribute, morph target, joint, weight and
/// colour: old vertices keep their numbers, copies at seams follow behind. Accessors that anybody
/// else uses are cloned, indices promoted when they must, Draco primitives stored uncompressed, lower
/// TEXCOORD sets that are missing are filled, TANGENT goes when its normal map's uv are replaced.
/// @pre `map` comes from quantizeForGltf
Result<Written> writeGltf(const GltfStore& store, const GltfSurface& part, const UvMap& map,
                          const WriteOptions& options);

}  // namespace hgp::io
