// How large a grid is.  Role: cells and spacing, from areas.
#pragma once

#include "hgp/grid/grid_options.h"
#include "hgp/mesh/mesh_data.h"
#include "hgp/mesh/tri_mesh.h"

namespace hgp {

/// Of the triangles in space.
double surfaceArea(const TriMesh& mesh);
/// Cells, spacing and cells per cone of an aligned map.
void describeGrid(const TriMesh& mesh, const UvMap& map, std::size_t coneCount, GridReport& report);

}  // namespace hgp
