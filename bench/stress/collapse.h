// Random edge collapses.  Role: coarse meshes of any genus, with the triangles that they have.
#pragma once

#include "hgp/mesh/mesh_data.h"
#include "random.h"

namespace hgp::stress {

/// Random edges between interior vertices collapsed to their middles until `triangles` are left or
/// none can be collapsed without changing the topology (link condition).
MeshData decimated(const MeshData& mesh, int triangles, Random& random);

}  // namespace hgp::stress
