// Merging matched vertices.  Role: the downward half of a multilevel bisection.
#pragma once

#include "hgp/linalg/ordering/weighted_graph.h"

namespace hgp::linalg {

/// One round of heavy-edge matching and contraction; clusters heavier than maxWeight are not formed.
CoarseLevel coarsen(const WeightedGraph& fine, int maxWeight);

}  // namespace hgp::linalg
