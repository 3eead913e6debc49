#include "hgp/features/index_paths.h"

namespace hgp {

IndexPaths::IndexPaths(const IndexGraph& graph) : graph_(graph) {
  const std::size_t count = at(graph.count());
  distance_.assign(count, 0.0);
  via_.assign(count, HalfedgeId());
  isForward_.assign(count, 0);
  from_.assign(count, -1);
}

std::vector<std::pair<HalfedgeId, int>> IndexPaths::stepsTo(int end, int sign) const {
  std::vector<std::pair<HalfedgeId, int>> steps;
  for (int n = end; from_[at(n)] >= 0; n = from_[at(n)]) {
    // The step leads from from_[n] to n; a unit moves back along it, towards the start, if sign is 1.
    if (via_[at(n)].isValid())
      steps.emplace_back(via_[at(n)], isForward_[at(n)] == (sign < 0) ? 1 : -1);
  }
  return steps;
}

}  // namespace hgp
