// The global scale at which a map is measured.  Role: distortion is a property of the shape of a map;
// how large the map is drawn must not count.
#pragma once

#include "hgp/improve/energy.h"
#include "hgp/improve/face_terms.h"

namespace hgp {

/// Mean of ψ over the surface, of the map divided by `scale`; +∞ unless all triangles are positive.
double meanEnergy(const EnergyExponents& exponents, const FaceTerms& terms, const FaceParts& parts,
                  double scale);

/// The scale with the least mean energy, found from `start` by Newton's method on its logarithm (without a
/// knee the mean is convex in it; with one each step minimises a majorizer).
/// @pre all triangles are positive
double bestScale(const EnergyExponents& exponents, const FaceTerms& terms, const FaceParts& parts,
                 double start);

}  // namespace hgp
