// Maps that are their own mirror images.  Role: half the unknowns, and what is symmetric on the surface is so in the map.
#pragma once

#include <memory>

#include "hgp/parametrize/parametrization.h"

namespace hgp {

/// Cones at these places have no mirror image of the same angle.
Failure unpairedCones(std::vector<Where> where);

/// Solves one side of the plane along the edges in it (parametrizeAlongFeatures), reflects the map to the other side and
/// verifies all of it on the whole surface. Features are those of `spec`, the edges in the plane and all boundary edges; cones come in pairs, or lie in the plane with an even k. Fails with kUsage where prescribed cones are no
/// mirror images of each other, and as parametrizeAlongFeatures(), with places on the whole surface.
/// @pre one component; hasTwoSides(); no edge is across the plane; features are mirror images of each other
Result<Parametrization> parametrizeSymmetric(const TriMesh& mesh,
                                             const std::shared_ptr<const Mirror>& mirror,
                                             const HolonomySpec& spec,
                                             const ParametrizeOptions& options);

}  // namespace hgp
