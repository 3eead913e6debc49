// Other automatic cones where the first ones have no map.  Role: whoever leaves the choice of cones to hgp is told that
// there is no map only after others were tried.
#pragma once

#include <functional>

#include "hgp/api/options.h"
#include "hgp/parametrize/parametrization.h"

namespace hgp::api {

/// Chooses cones for a purpose, and solves with them.
using SolveFor = std::function<Result<Parametrization>(ConesFor purpose)>;

/// If `run` has no certified map and its cones were chosen for a purpose alone (neither counted nor aligned): those for the
/// other purposes, the nearest in number first. Replaces `run` by the first certified result, with a note
/// ("cones-other"). Fails with kCancelled only.
Status mapWithOtherCones(const SolveOptions& options, const SolveFor& solve,
                         Result<Parametrization>& run, Notes& notes);

}  // namespace hgp::api
