// Unfolds quads in space.  Role: where cells are large for the surface, for instance around the rim of a thin plate, quads of
// an injective map may fold; moving some of their vertices along the surface helps.
#pragma once

#include "hgp/quads/quads.h"

namespace hgp {

/// Moves vertices of quads that countFoldedInSpace() counts along the surface, by less than an edge, as long as that lowers
/// their number or the folds. Cones and vertices on features and at the boundary stay, and so does what does not touch such a
/// quad. Returns how many quads less are folded.
int unfoldInSpace(const TriMesh& mesh, QuadMesh& quads);

}  // namespace hgp
