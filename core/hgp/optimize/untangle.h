// Untangling: from a seamless map with flipped triangles to a nearby one without.  Role: used where no set of
// frames gives a locally injective map; it has no frame conditions.
#pragma once

#include "hgp/optimize/untangler.h"

namespace hgp {

/// Minimises over seamless maps, by projected Newton steps with a line search [GKK21],
///
///   Σ_f (|f_z|² + |f_z̄|² + λ (D² + 1)) / χ(D, ε),   D = |f_z|² − |f_z̄|²,  χ = ½ (D + √(D² + ε²)),
///
/// each triangle in units of e^{u_f}, while ε shrinks with the most negative D. For ε → 0 and
/// D > 0 that is the conformal energy with a weak bound on scale: a barrier against flips. In a first phase
/// |f_z|² in D is replaced by A √(A² + ε), A the part of f_z along the frames of `system.seams` (framedModel), which decides
/// the winding numbers and opens what has collapsed; from time to time the frames are rotated smoothly after the map, which keeps their holonomy.
/// Ends soon after the last flip. The map is not harmonic.
/// @param x  the initial unknowns, any values
UntangleResult untangle(const SeamlessSystem& system, const Eigen::VectorXcd& x,
                        const UntangleOptions& options);

}  // namespace hgp
