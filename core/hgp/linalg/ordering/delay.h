// Where to eliminate the unknowns that change.  Role: balances work done once and work repeated.
#pragma once

#include <vector>

#include "hgp/linalg/ordering/ordering.h"

namespace hgp::linalg {

struct DelayOptions {
  int iterations = 12;  ///< how often the dynamic part is expected to be factored
  int depth = -1;       ///< ≥ 0: take this depth; −1: choose by estimated work
  double maxBytes = 1.5e9;
};

struct DelayedOrder {
  std::vector<int> order;  ///< elimination order of all unknowns
  int depth = 0;           ///< the depth that was used
};

/// Orders unknowns by `tree`, touched ones last within their node, each touched one moved up to its
/// ancestor at `depth` (root: 0) if it lies deeper; members of a clique that lie on separate branches
/// are moved up to where the branches meet first. Moving up keeps a separator tree valid.
DelayedOrder delayTouched(const Graph& pattern, const SeparatorTree& tree, const Cliques& cliques,
                          const DelayOptions& options);

}  // namespace hgp::linalg
