// The cones that a map has.  Role: what automatic cones become where a map without folds has others than were chosen.
#pragma once

#include "hgp/parametrize/after/solution.h"

namespace hgp {

/// The prescription that a map with positive triangles fulfils: the measured cones and turnings, and the handles as they
/// are, since the seams keep their rotations. Gauss–Bonnet holds, because it holds for every map.
/// @pre certificate.isMeasured, no triangle of which is not positive
CompleteSpec ownPrescription(const CompleteSpec& asked, const Certificate& certificate);

/// Makes the measured cones of `mapped` its prescription and certifies it again; result.spec and a note say so. Changes
/// nothing where the map is certified already, has a triangle that is not positive, or fails for another reason.
void keepOwnCones(const TriMesh& mesh, MappedSolution& mapped, Parametrization& result);

}  // namespace hgp
