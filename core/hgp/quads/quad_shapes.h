// Shapes of quads in space.  Role: the map is injective, but its quads may fold where cells are large for the surface.
#pragma once

#include "hgp/quads/quads.h"

namespace hgp {

/// The least of a quad's four corners: (b − a) × (d − a) · n, n the cross product of the diagonals, all vectors of unit
/// length; 0 for a corner without a side, and 1 for a quad of fewer than four vertices.
double scaledJacobian(const QuadMesh& quads, int quad);

/// Quads with a corner that does not turn the way the quad as a whole does: scaledJacobian() is not positive.
int countFoldedInSpace(const QuadMesh& quads);

}  // namespace hgp
