// Weakens automatic cones on coarse meshes.  Role: cones for which the mesh has enough triangles.
#pragma once

#include "hgp/mesh/angle_shortage_memo.h"
#include "hgp/mesh/holonomy_spec.h"

namespace hgp {

/// While findAngleShortage finds one, moves a unit of k from its strongest cone to the vertex within kReceivers edges
/// that then has the smallest angle per triangle. Σ k does not change. Stops after kMaxUnits units.
/// @param shortages  of this mesh
void makeRoom(const TriMesh& mesh, HolonomySpec& spec, AngleShortageMemo& shortages);
inline constexpr int kReceivers = 3;
inline constexpr int kMaxUnits = 64;

}  // namespace hgp
