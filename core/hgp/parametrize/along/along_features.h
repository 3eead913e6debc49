// Maps whose features are straight.  Role: the method of [BCW17 §7] with lines held exactly (docs/decisions/072).
#pragma once

#include "hgp/field/prepared_surface.h"
#include "hgp/parametrize/parametrization.h"

namespace hgp {

/// A map that sends every edge of spec.features, and every boundary edge, to a line u = const or v = const, exactly: both
/// ends have the same bits there. Cones and corners come from the aligned field, which has those of `spec`; turnings and handles must be the same.
/// Improvements and grids that are asked for keep the bits of straight features equal.
/// Fails with kUsage for options that do not go with features (frames of a file, q ≠ 4), with
/// kPrescription where the features contradict each other or the cones of `spec`, and as parametrize().
/// A map that is not certified is a successful return.
/// @pre one component; spec.features is not empty
Result<Parametrization> parametrizeAlongFeatures(PreparedSurface& surface, const HolonomySpec& spec,
                                                 const ParametrizeOptions& options);

/// Whether features have possible indices, with the cones and corners of `spec`; fails as parametrizeAlongFeatures() does where
/// they have none, and for q ≠ 4. Solves nothing, so that lengths are not looked at, nor turnings and handles, which straightened
/// steps change.
Status checkAlongFeatures(PreparedSurface& surface, const HolonomySpec& spec);

/// The number of cones of the field along the features, before any step or pair of them is left out; fails as
/// checkAlongFeatures().
Result<int> countConesAlong(PreparedSurface& surface, const HolonomySpec& spec);

}  // namespace hgp
