// A grid as the material of one mesh of a glTF.  Role: the glTF half of grid_material.h.
#pragma once

#include <string>

#include "hgp/base/result.h"
#include "hgp/io/written.h"

namespace hgp::io {

struct GltfGridPlace {
  int mesh = 0;
  int uvSet = -1;  ///< −1: the last one that the primitives have without a gap
};

/// The file with `picture`, a PNG, as a new image, and a new material for the primitives that have the uv set.
/// All other text and data stay byte for byte. @param scale  repeats of the picture per unit of uv, as JSON
Result<Bytes> gltfWithGrid(const Bytes& file, const GltfGridPlace& place, const std::string& scale,
                           ByteView picture);

}  // namespace hgp::io
