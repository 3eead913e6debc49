// Multiple edges of a quad mesh, found without the quad mesh.  Role: alignment refuses candidates with such edges, at a
// cost that grows with the length of the seams in cells and not with the number of cells.
#pragma once

#include "hgp/mesh/mesh_data.h"
#include "hgp/mesh/tri_mesh.h"

namespace hgp {

/// Whether countMultipleEdges(extractQuads(mesh, map, q)).pairs > 0. Two edges with the same ends are a loop of two cells
/// that encloses a cone or goes around a handle: otherwise it would bound a flat disk with two corners, which does not
/// exist. It thus meets the seams, and the ends of all grid edges that do are looked at.
/// @param isSeam  the cut to a disk with all cones on its boundary: no loop of the rest encloses a cone
/// False where the map is no grid of quads (see extractQuads).
bool hasMultipleEdges(const TriMesh& mesh, const UvMap& map, const PerEdge<char>& isSeam);

}  // namespace hgp
