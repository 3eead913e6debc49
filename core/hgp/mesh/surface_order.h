// An order of the faces that the surface alone determines.  Role: results that no numbering in a file can change, however a
// computation breaks ties or starts.
#pragma once

#include <vector>

#include "hgp/mesh/tri_mesh.h"

namespace hgp {

/// One halfedge of every face, breadth-first from the longest edge, counterclockwise from the halfedge through which a
/// face was reached: its order and its place in the face depend on positions and connectivity alone. Of edges of the same
/// length, that with the smaller ends comes first. Of several components, each starts at its first face in the input.
std::vector<HalfedgeId> surfaceOrder(const TriMesh& mesh);

}  // namespace hgp
