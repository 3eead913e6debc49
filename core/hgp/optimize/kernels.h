// Vertices of flipped triangles move into the kernels of the polygons around them.  Role: the last step of untangling,
// where Newton steps leave a few triangles crushed beyond what float64 resolves in their energy.
#pragma once

#include "hgp/optimize/untangle.h"

namespace hgp {

/// The triangles of a vertex are all positive where it lies in the kernel of the polygon around it: the intersection of
/// the half-planes left of its sides. The deepest point of that intersection is a linear program in three unknowns.
/// Moves vertices of flipped triangles and their neighbours to these points, pass by pass, also where a kernel is empty
/// and the point only the least outside. Angle sums then are multiples of 2π/q again, though perhaps others than asked.
/// @param result  replaced if no flipped triangle is left, unchanged otherwise
void moveIntoKernels(const SeamlessSystem& system, UntangleResult& result);

}  // namespace hgp
