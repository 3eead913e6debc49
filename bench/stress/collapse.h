// Random edge collapses.  Role: coarse meshes of any genus with realistic triangles.
#pragma once

#include "hgp/mesh/mesh_data.h"
#include "random.h"

namespace hgp::stress {

/// Collapses random edges between interior vertices to their midpoints until `triangles` are left or
/// no edge can be collapsed without changing the topology (link condition).
MeshData decimated(const MeshData& mesh, int triangles, Random& random);

}  // namespace hgp::stress
