// The method in one metric.  Role: [BCW17 §7] for parametrize(), which tries the surface's own metric and then
// the evened one (parametrize.cpp).
#pragma once

#include <memory>

#include "hgp/field/prepared_surface.h"
#include "hgp/parametrize/parametrization.h"

namespace hgp {

/// A search whose steps were spent without a certified map, and what it needs to go on.
struct PausedSearch;

/// parametrize(), with weights and frames from the metric of `surface` alone.
/// @param paused  where not null and set, the search that goes on, to the steps of `options` in all; its earlier rounds are not
///   repeated, neither in the work nor in the result. Afterwards the search that may go on, or null.
Result<Parametrization> parametrizeInMetric(PreparedSurface& surface, const HolonomySpec& spec,
                                            const ParametrizeOptions& options,
                                            std::shared_ptr<PausedSearch>* paused = nullptr);

}  // namespace hgp
