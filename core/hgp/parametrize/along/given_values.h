// Unknowns whose values integers give.  Role: what is known of a map on a grid before any program is solved.
#pragma once

#include <utility>
#include <vector>

#include "hgp/parametrize/along/straight_setup.h"

namespace hgp {

using GivenValues = std::vector<std::pair<int, double>>;  ///< real unknowns with their values

/// Parallel lines and seams that do not turn leave a translation of the map free: it is fixed by one more value in each
/// coordinate that needs it.
/// @param variables  real unknowns that integers determine
void holdOrigin(const TriMesh& mesh, const StraightSetup& setup, const std::vector<int>& variables,
                GivenValues& given);

/// Triangles of which the given values determine all six coordinates, and whose area is not positive: no values of the other
/// unknowns change that. Ascending; exact where the values are integers.
std::vector<FaceId> reversedByGiven(const TriMesh& mesh, const StraightSetup& setup,
                                    const GivenValues& given);

}  // namespace hgp
