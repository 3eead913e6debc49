// Completes prescribed cones to a balance.  Role: the cones that are missing for Gauss–Bonnet, where they cause the least
// distortion.
#pragma once

#include "hgp/base/result.h"
#include "hgp/mesh/holonomy_spec.h"

namespace hgp {

class PreparedSurface;

/// `spec` with the cones that Σ(q − k) + Σl = q·χ [BCW17 Lemma 6.2] misses, placed by the energy of the cone metric
/// (ConeCost): one by one, or those of the smoothest field reduced to as many, whichever has less of it. The cones of
/// `spec` stay as they are, and new ones share no triangle with them or with one another where that is possible. A loop
/// whose turning is open takes any remainder, so that nothing is added. Fails with kPrescription where no vertex can take
/// the remainder, or for what checkPrescription refuses besides. The connection of `surface` is then prepared.
Result<HolonomySpec> balanceCones(PreparedSurface& surface, HolonomySpec spec);

}  // namespace hgp
