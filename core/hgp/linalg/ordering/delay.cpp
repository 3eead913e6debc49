#include "hgp/linalg/ordering/delay.h"

#include <algorithm>
#include <limits>

namespace hgp::linalg {
namespace {

// Flop-equivalents per number moved while assembling, and per node: only ratios matter.
constexpr double kMoveCost = 8.0;
constexpr double kNodeCost = 2e4;
// Inside a leaf, minimum degree saves about this fraction of the dense work.
constexpr double kLeafSparsity = 0.3;

double panelWork(double s, double r) { return s * s * s / 6 + s * s * r / 2 + s * r * r / 2; }

class DelayPlanner {
 public:
  DelayPlanner(const Graph& pattern, const SeparatorTree& tree, const Cliques& cliques,
               const DelayOptions& options)
      : pattern_(pattern), tree_(tree), options_(options) {
    const int count = tree.nodeCount();
    node_.resize(tree.order.size());
    for (int t = 0; t < count; ++t)
      for (int k = tree.nodeStart[t]; k < tree.nodeStart[t + 1]; ++k) node_[tree.order[k]] = t;
    depth_.assign(static_cast<std::size_t>(count), 0);
    for (int t = count - 1; t >= 0; --t)
      if (tree.parent[t] >= 0) depth_[t] = depth_[tree.parent[t]] + 1;
    touched_.assign(tree.order.size(), 0);
    for (const std::vector<int>& clique : cliques)
      for (const int v : clique) touched_[v] = 1;
    for (const std::vector<int>& clique : cliques) joinBranches(clique);
  }

  DelayedOrder plan() {
    DelayedOrder result;
    result.depth = options_.depth >= 0 ? options_.depth : bestDepth();
    for (std::size_t v = 0; v < node_.size(); ++v)
      if (touched_[v]) node_[v] = ancestorAt(node_[v], result.depth);
    std::vector<std::vector<int>> late(tree_.parent.size());
    for (const int v : tree_.order)
      if (touched_[v]) late[node_[v]].push_back(v);
    result.order.reserve(tree_.order.size());
    for (int t = 0; t < tree_.nodeCount(); ++t) {
      for (int k = tree_.nodeStart[t]; k < tree_.nodeStart[t + 1]; ++k)
        if (!touched_[tree_.order[k]]) result.order.push_back(tree_.order[k]);
      result.order.insert(result.order.end(), late[t].begin(), late[t].end());
    }
    return result;
  }

 private:
  int ancestorAt(int t, int depth) const {
    while (depth_[t] > depth) t = tree_.parent[t];
    return t;
  }
  int meet(int a, int b) const {
    while (a != b) {
      if (depth_[a] >= depth_[b])
        a = tree_.parent[a];
      else
        b = tree_.parent[b];
    }
    return a;
  }
  bool isAncestor(int up, int down) const { return ancestorAt(down, depth_[up]) == up; }

  void joinBranches(const std::vector<int>& clique) {
    int deepest = -1;
    for (const int v : clique)
      if (deepest < 0 || depth_[node_[v]] > depth_[deepest]) deepest = node_[v];
    for (const int v : clique) {
      if (isAncestor(node_[v], deepest)) continue;
      // v is on a side branch: everything at or below the fork goes to the fork.
      const int fork = meet(node_[v], deepest);
      for (const int u : clique)
        if (depth_[node_[u]] > depth_[fork]) node_[u] = ancestorAt(node_[u], depth_[fork]);
      deepest = fork;
    }
  }

  // Boundary of each node's subtree: how many ancestors' unknowns it couples to. Counted over the
  // tree as given; delayed unknowns are added by the estimate itself.
  std::vector<int> boundarySizes() const {
    const int count = tree_.nodeCount();
    std::vector<std::vector<int>> rows(static_cast<std::size_t>(count));
    std::vector<int> home(node_.size()), seen(node_.size(), -1), size(rows.size(), 0);
    for (int t = 0; t < count; ++t)
      for (int k = tree_.nodeStart[t]; k < tree_.nodeStart[t + 1]; ++k) home[tree_.order[k]] = t;
    for (int t = 0; t < count; ++t) {
      std::vector<int> mine;
      const auto add = [&](int u) {
        if (home[u] <= t || seen[u] == t) return;
        seen[u] = t;
        mine.push_back(u);
      };
      for (const int u : rows[t]) add(u);
      for (int k = tree_.nodeStart[t]; k < tree_.nodeStart[t + 1]; ++k) {
        const int v = tree_.order[k];
        for (const int* u = pattern_.begin(v); u != pattern_.end(v); ++u) add(*u);
      }
      rows[t] = {};
      size[t] = static_cast<int>(mine.size());
      const int p = tree_.parent[t];
      if (p >= 0) rows[p].insert(rows[p].end(), mine.begin(), mine.end());
    }
    return size;
  }

  struct Estimate {
    double work = 0, bytes = 0;
  };

  void addPanel(bool isDynamic, double share, double s, double r, Estimate* e) const {
    if (s <= 0) return;
    const double moves = kMoveCost * (s + r) * (s + r);
    const double once = share * panelWork(s, r);
    e->work += isDynamic ? options_.iterations * (8.0 * once + 4.0 * moves + kNodeCost)
                         : 4.0 * once + 2.0 * moves + kNodeCost;
    e->bytes += (isDynamic ? 32.0 : 16.0) * s * (s + r) * (share < 1 ? 2 * share : 1.0);
    if (isDynamic) e->bytes += 8.0 * r * r;
  }

  // Every touched unknown deeper than `depth` is moved up; `own` counts touched ones by native node.
  Estimate estimate(int depth, const std::vector<int>& own, const std::vector<int>& native,
                    const std::vector<int>& boundary) const {
    const int count = tree_.nodeCount();
    std::vector<int> passing(static_cast<std::size_t>(count), 0);
    std::vector<char> below(static_cast<std::size_t>(count), 0);
    Estimate e;
    for (int t = 0; t < count; ++t) {
      const int p = tree_.parent[t];
      const bool isLeaf = t == 0 || tree_.parent[t - 1] != t;
      const double share = isLeaf ? kLeafSparsity : 1.0;
      const int arriving = passing[t] + own[t];
      const double rest = tree_.nodeStart[t + 1] - tree_.nodeStart[t] - native[t];
      const double b = boundary[t];
      if (depth_[t] > depth) {
        addPanel(false, share, rest, b + arriving, &e);
        if (p >= 0) passing[p] += arriving;
        continue;
      }
      const bool isDynamic = below[t] != 0;
      addPanel(isDynamic, share, rest, b + arriving, &e);
      addPanel(true, 1.0, arriving, b, &e);
      if (p >= 0 && (isDynamic || arriving > 0)) below[p] = 1;
    }
    return e;
  }

  int bestDepth() const {
    const std::vector<int> boundary = boundarySizes();
    std::vector<int> own(tree_.parent.size(), 0), native(own);
    for (std::size_t v = 0; v < node_.size(); ++v)
      if (touched_[v]) ++own[node_[v]];
    for (int t = 0; t < tree_.nodeCount(); ++t)
      for (int k = tree_.nodeStart[t]; k < tree_.nodeStart[t + 1]; ++k)
        native[t] += touched_[tree_.order[k]];
    const int deepest = depth_.empty() ? 0 : *std::max_element(depth_.begin(), depth_.end());
    std::vector<Estimate> estimates;
    double least = std::numeric_limits<double>::infinity();
    for (int depth = 0; depth <= deepest; ++depth) {
      estimates.push_back(estimate(depth, own, native, boundary));
      least = std::min(least, estimates.back().bytes);
    }
    const double limit = std::max(options_.maxBytes,
                                  1.2 * least);  // the static part alone may exceed the limit
    int best = -1;
    for (int depth = 0; depth <= deepest; ++depth)
      if (estimates[depth].bytes <= limit &&
          (best < 0 || estimates[depth].work < estimates[best].work))
        best = depth;
    return best;
  }

  const Graph& pattern_;
  const SeparatorTree& tree_;
  const DelayOptions& options_;
  std::vector<int> node_;   // tree node that eliminates each unknown
  std::vector<int> depth_;  // of each tree node
  std::vector<char> touched_;
};

}  // namespace

DelayedOrder delayTouched(const Graph& pattern, const SeparatorTree& tree, const Cliques& cliques,
                          const DelayOptions& options) {
  return DelayPlanner(pattern, tree, cliques, options).plan();
}

}  // namespace hgp::linalg
