// Random surfaces from a seed.  Role: meshes for which nothing was tuned, without third-party copyright.
#pragma once

#include <cstdint>
#include <string>

#include "hgp/mesh/mesh_data.h"

namespace hgp::stress {

/// Rods along a random graph, blended on a grid of 18 to 80 cells, so that some handles are only a
/// few triangles long. Of several such shapes, the first with the requested genus (or else the nearest) is taken, and
/// `holes` balls are cut out. One component, 400 to 20 000 triangles.
MeshData randomSurface(const std::string& name, int genus, int holes);

}  // namespace hgp::stress
