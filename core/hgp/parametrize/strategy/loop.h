// The method in one metric.  Role: [BCW17 §7] for parametrize(), which tries the surface's own metric and then
// the evened one (parametrize.cpp).
#pragma once

#include "hgp/field/prepared_surface.h"
#include "hgp/parametrize/parametrization.h"

namespace hgp {

/// parametrize(), with weights and frames from the metric of `surface` alone.
Result<Parametrization> parametrizeInMetric(PreparedSurface& surface, const HolonomySpec& spec,
                                            const ParametrizeOptions& options);

}  // namespace hgp
