// Least-squares conformal maps.  Role: shows how conformal maps of a cut surface can be without seam
// conditions, for comparison with `--improve conformal`.
#pragma once

#include "hgp/improve/face_terms.h"

namespace hgp::bench {

/// Lévy, Petitjean, Ray and Maillot 2002: minimizes Σ A |f_z̄|² over the free unknowns. The held unknowns
/// (two vertices; otherwise the map is constant) determine position, rotation and scale. Triangles may flip.
/// Empty if the normal equations cannot be factored.
Eigen::VectorXcd leastSquaresConformal(const FaceTerms& terms);

}  // namespace hgp::bench
