// Automatic cones on coarse meshes.  Role: a choice of cones that the mesh has enough triangles for.
#pragma once

#include "hgp/mesh/holonomy_spec.h"

namespace hgp {

/// While findAngleShortage finds one, its strongest cone gives a unit to the vertex within kReceivers edges that then has the
/// smallest angle per triangle. Σ k stays. Ends as it is after kMostUnits.
void makeRoom(const TriMesh& mesh, HolonomySpec& spec);
inline constexpr int kReceivers = 3;
inline constexpr int kMostUnits = 64;

}  // namespace hgp
