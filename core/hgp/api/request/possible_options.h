// Options that contradict each other.  Role: checked before anything is solved.
#pragma once

#include "hgp/api/options.h"

namespace hgp::api {

/// Fails with kUsage for options that do not go together, or not with the order q of the cones.
Status checkOptions(const SolveOptions& options, int q);

}  // namespace hgp::api
