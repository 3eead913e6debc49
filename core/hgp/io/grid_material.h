// A grid as the material of a mapped mesh, so that every viewer shows the map.  Role: changes only the
// appearance; everything else in the file stays byte for byte.
#pragma once

#include <string_view>
#include <vector>

#include "hgp/base/result.h"
#include "hgp/io/written.h"

namespace hgp::io {

struct GridMaterial {
  double tiles = 1;  ///< squares per unit of uv; the picture consists of two by two squares
  int mesh = 0;      ///< glTF: the mesh whose primitives get the material (Surface::meshInFile)
  int uvSet = -1;    ///< glTF; −1: the last set before the first one that a primitive lacks
};

/// The files of Document::write with the grid. glTF: an embedded image, and a material for the
/// primitives that have the uv set. OBJ: a material library and a picture as side files; lines that name other
/// materials become comments. `format`: "glb", "gltf" or "obj"; kUnsupported for others.
Result<std::vector<OutputFile>> withGridMaterial(std::vector<OutputFile> files,
                                                 std::string_view format, const GridMaterial& grid);
/// The same for several meshes of a glTF, which share the image.
Result<std::vector<OutputFile>> withGridMaterials(std::vector<OutputFile> files,
                                                  const std::vector<GridMaterial>& grids);

}  // namespace hgp::io
