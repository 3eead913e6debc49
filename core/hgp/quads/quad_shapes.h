// Shapes of quads in space.  Role: the map is injective, but its quads may fold where cells are large for the surface.
#pragma once

#include "hgp/quads/quads.h"

namespace hgp {

/// Quads of four vertices with a corner that does not turn the way the quad as a whole does, that is, whose scaled
/// Jacobian is not positive: (b − a) × (d − a) · n ≤ 0 for n, the cross product of the diagonals.
int countFoldedInSpace(const QuadMesh& quads);

}  // namespace hgp
