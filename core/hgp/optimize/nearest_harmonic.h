// From the minimiser of a penalty form to the harmonic map of least distortion.  Role: harmonic maps of surfaces with so
// many boundary vertices and cones that the dense form of HarmonicBasis would be too large.
#pragma once

#include "hgp/optimize/program_form.h"

namespace hgp {

/// Of all x with L x = 0, the one of least distortion. `x` is the minimiser of ‖W L x‖² + δ distortion(x), W = diag(e^{−u}),
/// whose gradient, δ ∇distortion = −2 Lᴴ W² L x, is a combination of the rows; so is every step from it
///
///   Δx = −K⁻¹ Lᴴ W λ,  K = Lᴴ W² L + δ D,
///
/// and where L (x + Δx) = 0, x + Δx is the constrained minimiser. The λ of that are found by conjugate gradients on
/// (W L K⁻¹ Lᴴ W) λ = W L x, whose eigenvalues are below 1, most of them near it: few solves with the factor of K.
/// @param form  built with this distortion term on all faces and without frame conditions
/// @param x     all unknowns
/// The result violates rows by what rounding leaves, or where that many steps do not suffice, by more.
Eigen::VectorXcd nearestHarmonic(const ProgramInput& in, const ProgramForm& form,
                                 const HeldUnknowns& held, Eigen::VectorXcd x);

}  // namespace hgp
