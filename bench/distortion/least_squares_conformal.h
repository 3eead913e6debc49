// Least-squares conformal maps.  Role: how conformal the triangles of a cut surface can be where nothing
// holds its seams; what `--improve conformal` is measured beside.
#pragma once

#include "hgp/improve/face_terms.h"

namespace hgp::bench {

/// Lévy, Petitjean, Ray and Maillot 2002: minimizes Σ A |f_z̄|² over the free unknowns. What the terms hold
/// (two vertices, or the answer is a point) gives the map its place, angle and size. Triangles may flip.
/// Empty where the normal equations cannot be factored.
Eigen::VectorXcd leastSquaresConformal(const FaceTerms& terms);

}  // namespace hgp::bench
