// Cones that are alone between features.  Role: conditions on lengths that the equations of a patch do not have
// (docs/decisions/112).
#pragma once

#include "hgp/features/aligned_field.h"
#include "hgp/optimize/straight_program.h"

namespace hgp {

/// In a patch between features with one cone of index k and k corners with a = 1, none with a ≥ 3, the signed distances of the
/// cone from the lines of the k sides. They are positive in every locally injective map: the proof is in the decision.
std::vector<SideDistance> distancesOfLoneCones(const SeamlessSystem& system,
                                               const RealUnknowns& unknowns,
                                               const std::vector<StraightEdge>& edges,
                                               const AlignedField& aligned);

}  // namespace hgp
