#include <algorithm>

#include "hgp/base/check.h"
#include "hgp/linalg/ordering/leaf_order.h"
#include "hgp/linalg/ordering/ordering.h"

namespace hgp::linalg {
namespace {

// Collects vertices by node and writes the tree out again.
SeparatorTree rebuild(const SeparatorTree& tree, const std::vector<std::vector<int>>& members) {
  SeparatorTree result;
  result.parent = tree.parent;
  result.nodeStart.push_back(0);
  for (const std::vector<int>& node : members) {
    result.order.insert(result.order.end(), node.begin(), node.end());
    result.nodeStart.push_back(static_cast<int>(result.order.size()));
  }
  return result;
}

std::vector<std::vector<int>> membersOf(const SeparatorTree& tree) {
  std::vector<std::vector<int>> members(tree.parent.size());
  for (int t = 0; t < tree.nodeCount(); ++t)
    members[t].assign(tree.order.begin() + tree.nodeStart[t],
                      tree.order.begin() + tree.nodeStart[t + 1]);
  return members;
}

class Appender {
 public:
  Appender(const SeparatorTree& tree, int count)
      : tree_(tree),
        members_(membersOf(tree)),
        node_(static_cast<std::size_t>(count), -1),
        depth_(tree.parent.size(), 0) {
    for (int t = 0; t < tree.nodeCount(); ++t)
      for (const int v : members_[t]) node_[v] = t;
    for (int t = tree.nodeCount() - 1; t >= 0; --t)
      if (tree.parent[t] >= 0) depth_[t] = depth_[tree.parent[t]] + 1;
  }

  // Neighbours on one path to the root: the lowest of their nodes will do, as its ancestors are
  // comparable with it. Otherwise the highest node where that path is joined by a branch.
  void place(int v, const Graph& graph) {
    int lowest = -1;
    for (const int* u = graph.begin(v); u != graph.end(v); ++u)
      if (node_[*u] >= 0 && (lowest < 0 || depth_[node_[*u]] > depth_[lowest])) lowest = node_[*u];
    int at = lowest < 0 ? tree_.nodeCount() - 1 : lowest;
    for (const int* u = graph.begin(v); u != graph.end(v); ++u) {
      if (node_[*u] < 0) continue;
      const int fork = meet(node_[*u], lowest);
      if (fork != node_[*u] && depth_[fork] < depth_[at]) at = fork;
    }
    node_[v] = at;
    members_[at].push_back(v);
  }

  SeparatorTree finish() const { return rebuild(tree_, members_); }

 private:
  int meet(int a, int b) const {
    while (a != b) {
      if (depth_[a] >= depth_[b])
        a = tree_.parent[a];
      else
        b = tree_.parent[b];
    }
    return a;
  }

  const SeparatorTree& tree_;
  std::vector<std::vector<int>> members_;
  std::vector<int> node_, depth_;
};

}  // namespace

SeparatorTree appendVertices(const SeparatorTree& tree, const Graph& graph) {
  const int old = static_cast<int>(tree.order.size());
  HGP_CHECK(old <= graph.size(), "tree of %d for %d vertices", old, graph.size());
  Appender appender(tree, graph.size());
  for (int v = old; v < graph.size(); ++v) appender.place(v, graph);
  return appender.finish();
}

SeparatorTree restrictTree(const SeparatorTree& tree, const std::vector<int>& keep) {
  HGP_CHECK(keep.size() == tree.order.size(), "%d names for %d vertices",
            static_cast<int>(keep.size()), static_cast<int>(tree.order.size()));
  std::vector<std::vector<int>> members = membersOf(tree);
  for (std::vector<int>& node : members) {
    std::vector<int> kept;
    for (const int v : node)
      if (keep[v] >= 0) kept.push_back(keep[v]);
    node = std::move(kept);
  }
  return rebuild(tree, members);
}

}  // namespace hgp::linalg
