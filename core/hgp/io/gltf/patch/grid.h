// A grid as the material of meshes of a glTF.  Role: the glTF half of grid_material.h.
#pragma once

#include <string>
#include <vector>

#include "hgp/base/result.h"
#include "hgp/io/written.h"

namespace hgp::io {

struct GltfGridPlace {
  int mesh = 0;
  int uvSet = -1;     ///< −1: the last one that the primitives have without a gap
  std::string scale;  ///< repeats of the picture per unit of uv, as JSON
};

/// The file with `picture`, a PNG, as a new image, and per place a new material for the primitives that have the uv
/// set. All other text and data stay byte for byte.
Result<Bytes> gltfWithGrids(const Bytes& file, const std::vector<GltfGridPlace>& places,
                            ByteView picture);

}  // namespace hgp::io
