// The map of one mesh as it is written.  Role: what the writer is given for each mesh.
#pragma once

#include <optional>
#include <string>

#include "hgp/io/gltf/decode/weld.h"
#include "hgp/mesh/mesh_data.h"

namespace hgp::io {

struct GltfMap {
  const GltfSurface* part = nullptr;
  const UvMap* map = nullptr;
  std::optional<std::string> cones;
  int uvSet = -1;                       ///< as WriteOptions::uvSet, for this mesh
  std::optional<bool> pointsMaterials;  ///< likewise
};

}  // namespace hgp::io
