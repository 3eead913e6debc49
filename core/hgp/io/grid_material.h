// A grid as the material of a mapped mesh, so that the map is seen wherever the file is opened. Role: looks only;
// everything else in the file keeps its bytes.
#pragma once

#include <string_view>
#include <vector>

#include "hgp/base/result.h"
#include "hgp/io/written.h"

namespace hgp::io {

struct GridMaterial {
  double tiles = 1;  ///< per unit of uv; the picture shows two by two of them
  int mesh = 0;      ///< glTF: whose primitives
  int uvSet = -1;    ///< glTF: −1: the last one that they have without a gap
};

/// The files of Document::write with the grid. glTF: an image, inside the file, and a material for the
/// primitives that have the uv set. OBJ: a library and a picture beside it; lines that name other materials
/// become comments. `format`: "glb", "gltf" or "obj"; kUnsupported for others.
Result<std::vector<OutputFile>> withGridMaterial(std::vector<OutputFile> files,
                                                 std::string_view format, const GridMaterial& grid);

}  // namespace hgp::io
