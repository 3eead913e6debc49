// Cheapest paths of units of index.  Role: the search of index_flow.h and index_sums.h.
#pragma once

#include <algorithm>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include "hgp/features/index_graph.h"

namespace hgp {

/// Dijkstra's paths in an IndexGraph.
class IndexPaths {
 public:
  explicit IndexPaths(const IndexGraph& graph);

  /// From `starts`, each with its cost; calls use(node, distance) for every node, nearest first, until that returns false.
  /// @param jumps  jumps(n, to): calls to(node, cost) for nodes that are reached from n without a step
  template <class Jumps, class Use>
  void search(const std::vector<std::pair<int, double>>& starts, const Jumps& jumps,
              const Use& use) {
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
      const auto [d, n] = queue.top();
      queue.pop();
      if (d > distance_[at(n)]) continue;
      if (!use(n, d)) break;
      graph_.forSteps(n, [&, d = d, n = n](HalfedgeId h, bool isForward, int to) {
        reach(to, d + kEdgeCost, n, h, isForward);
      });
      jumps(n, [&, d = d, n = n](int to, double cost) {
        reach(to, d + cost, n, HalfedgeId(), false);
      });
    }
  }
  template <class Use>
  void search(int start, const Use& use) {
    search(
        {{start, 0.0}}, [](int, const auto&) {}, use);
  }

  double distance(int n) const { return distance_[at(n)]; }
  bool isReached(int n) const { return distance(n) < std::numeric_limits<double>::infinity(); }
  /// The steps of a unit that moves from a node that was found to its start (sign 1), or from there to it (−1).
  std::vector<std::pair<HalfedgeId, int>> stepsTo(int end, int sign) const;

 private:
  using Entry = std::pair<double, int>;
  const IndexGraph& graph_;
  std::vector<double> distance_;
  std::vector<HalfedgeId> via_;
  std::vector<char> isForward_;
  std::vector<int> from_;
};

}  // namespace hgp
