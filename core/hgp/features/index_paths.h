// Cheapest paths of units of index.  Role: the search of index_flow.h and index_sums.h.
#pragma once

#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "hgp/features/index_graph.h"

namespace hgp {

/// Dijkstra's paths in an IndexGraph.
class IndexPaths {
 public:
  using Starts = std::vector<std::pair<int, double>>;  ///< nodes, each with its cost
  /// Is called with every node and its distance, nearest first, until it returns false.
  using Use = std::function<bool(int, double)>;

  explicit IndexPaths(const IndexGraph& graph);

  /// Within the patch of `start`.
  void search(int start, const Use& use) { search({{start, 0.0}}, 0, use); }
  /// Of a unit to `starts` (1) or from them (−1), across features as well: at a vertex on Γ, one sector is given what another
  /// loses, at the difference of their costs. With 0 as `units`, within patches.
  void search(const Starts& starts, int units, const Use& use);

  double distance(int n) const { return distance_[at(n)]; }
  bool isReached(int n) const { return distance(n) < std::numeric_limits<double>::infinity(); }
  /// The steps of a unit that moves from a node that was found to its start (sign 1), or from there to it (−1).
  std::vector<std::pair<HalfedgeId, int>> stepsTo(int end, int sign) const;

 private:
  const IndexGraph& graph_;
  std::vector<double> distance_;
  std::vector<HalfedgeId> via_;
  std::vector<char> isForward_;
  std::vector<int> from_;
};

}  // namespace hgp
