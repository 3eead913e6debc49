// Surfaces from a seed.  Role: meshes that nobody has tuned to, and none that somebody else owns.
#pragma once

#include <cstdint>
#include <string>

#include "hgp/mesh/mesh_data.h"

namespace hgp::stress {

/// Rods along a random graph, grown together on a grid of 18 to 80 cells, so that some handles are a
/// few triangles long; of several such shapes the first of the asked genus (the nearest where none
/// is), `holes` balls cut out. One component, 400 to 20 000 triangles.
MeshData randomSurface(const std::string& name, int genus, int holes);

}  // namespace hgp::stress
