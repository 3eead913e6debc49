#include "hgp/features/index_paths.h"

#include <algorithm>
#include <queue>

namespace hgp {

IndexPaths::IndexPaths(const IndexGraph& graph) : graph_(graph) {
  const std::size_t count = at(graph.count());
  distance_.assign(count, 0.0);
  via_.assign(count, HalfedgeId());
  isForward_.assign(count, 0);
  from_.assign(count, -1);
}

void IndexPaths::search(const Starts& starts, int units, const Use& use) {
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  std::fill(distance_.begin(), distance_.end(), std::numeric_limits<double>::infinity());
  const auto reach = [&](int to, double d, int from, HalfedgeId via, bool isForward) {
    if (d >= distance_[at(to)]) return;
    distance_[at(to)] = d;
    from_[at(to)] = from;
    via_[at(to)] = via;
    isForward_[at(to)] = isForward;
    queue.push({d, to});
  };
  for (const auto& [n, d] : starts) reach(n, d, -1, HalfedgeId(), false);
  while (!queue.empty()) {
    const double d = queue.top().first;
    const int n = queue.top().second;
    queue.pop();
    if (d > distance_[at(n)]) continue;
    if (!use(n, d)) break;
    graph_.forSteps(n, [&](HalfedgeId h, bool isForward, int to) {
      reach(to, d + kEdgeCost, n, h, isForward);
    });
    if (units == 0 || !graph_.isSector(n)) continue;
    const double here = graph_.changeOf(n, -units);
    if (isImpossible(here)) continue;
    for (const int other : graph_.sectorsAt(graph_.vertexOf(n))) {
      const double there = graph_.changeOf(other, units);
      if (other == n || isImpossible(there)) continue;
      reach(other, d + kEdgeCost + std::max(0.0, here + there), n, HalfedgeId(), false);
    }
  }
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
