// The global scale at which distortion is measured.  Role: distortion must not depend on the size of the map.
#pragma once

#include "hgp/improve/energy.h"
#include "hgp/improve/face_terms.h"

namespace hgp {

/// Mean of ψ over the surface, of the map divided by `scale`; +∞ unless all triangles are positive.
double meanEnergy(const EnergyExponents& exponents, const FaceTerms& terms, const FaceParts& parts,
                  double scale);

/// The scale with minimum mean energy, by Newton's method on its logarithm from `start` (without a
/// knee the mean is convex in it; with one, each step minimises a majorizer).
/// @pre all triangles are positive
double bestScale(const EnergyExponents& exponents, const FaceTerms& terms, const FaceParts& parts,
                 double start);

}  // namespace hgp
