#include "hgp/linalg/ordering/ordering.h"

#include <algorithm>

#include "hgp/base/check.h"
#include "hgp/linalg/ordering/bisection.h"
#include "hgp/linalg/ordering/leaf_order.h"

namespace hgp::linalg {
namespace {

class Dissector {
 public:
  Dissector(const Graph& graph, const DissectionOptions& options)
      : g_(graph),
        options_(options),
        local_(static_cast<std::size_t>(graph.size()), -1),
        denseDegree_(denseDegree(graph.size())),
        leafOrder_(graph, options.separatorWidth, denseDegree_) {}

  SeparatorTree run() {
    tree_.order.reserve(static_cast<std::size_t>(g_.size()));
    tree_.nodeStart.push_back(0);
    std::vector<int> dense;
    Part whole = wholeGraph(&dense);
    const int root = dissect(std::move(whole));
    // Vertices of extreme degree would enlarge every cut; eliminated last, each costs one row of each panel.
    tree_.order.insert(tree_.order.end(), dense.begin(), dense.end());
    tree_.nodeStart.back() += static_cast<int>(dense.size());
    HGP_CHECK(root + 1 == tree_.nodeCount(), "root is node %d of %d", root, tree_.nodeCount());
    return std::move(tree_);
  }

 private:
  int weightOf(int v) const {
    return options_.vertexWeights.empty() ? 1 : options_.vertexWeights[v];
  }

  // All vertices but the dense ones, neighbours close together: a mesh file in random order would
  // otherwise miss the cache at every step of the first levels.
  std::vector<int> breadthFirst() const {
    std::vector<int> visited;
    std::vector<char> seen(static_cast<std::size_t>(g_.size()), 0);
    visited.reserve(seen.size());
    for (int v = 0; v < g_.size(); ++v) seen[v] = g_.degree(v) > denseDegree_;
    std::size_t next = 0;
    for (int v = 0; v < g_.size(); ++v) {
      if (seen[v]) continue;
      seen[v] = 1;
      visited.push_back(v);
      for (; next < visited.size(); ++next)
        for (const int* u = g_.begin(visited[next]); u != g_.end(visited[next]); ++u) {
          if (seen[*u]) continue;
          seen[*u] = 1;
          visited.push_back(*u);
        }
    }
    return visited;
  }

  Part wholeGraph(std::vector<int>* dense) {
    const int n = g_.size();
    std::vector<int> keep = breadthFirst();
    for (int v = 0; v < n; ++v)
      if (g_.degree(v) > denseDegree_) dense->push_back(v);
    for (std::size_t i = 0; i < keep.size(); ++i) local_[keep[i]] = static_cast<int>(i);
    Part part;
    part.graph.neighbours.reserve(g_.neighbours.size());
    for (const int v : keep) {
      for (const int* u = g_.begin(v); u != g_.end(v); ++u)
        if (local_[*u] >= 0) part.graph.neighbours.push_back(local_[*u]);
      part.graph.start.push_back(static_cast<int>(part.graph.neighbours.size()));
      part.graph.vertexWeight.push_back(weightOf(v));
    }
    part.graph.edgeWeight.assign(part.graph.neighbours.size(), 1);
    for (const int v : keep) local_[v] = -1;
    part.vertex = std::move(keep);
    return part;
  }

  // Returns the node at the top of this part; nodes are numbered as they are finished: postorder.
  int dissect(Part part) {
    if (part.graph.size() <= options_.leafSize) return leaf(part.vertex);
    std::vector<char> side = bisect(&part, options_.imbalance);
    coverCut(g_, part, options_.separatorWidth, &local_, &side);
    std::vector<int> separator;
    for (int v = 0; v < part.graph.size(); ++v)
      if (side[v] == 2) separator.push_back(part.vertex[v]);
    Part first = subPart(part, side, 0), second = subPart(part, side, 1);
    const std::size_t largest = std::max(first.vertex.size(), second.vertex.size());
    if (largest == part.vertex.size()) return leaf(part.vertex);  // nothing to cut
    part = {};
    int children[2];
    int count = 0;
    if (!first.vertex.empty()) children[count++] = dissect(std::move(first));
    if (!second.vertex.empty()) children[count++] = dissect(std::move(second));
    tree_.order.insert(tree_.order.end(), separator.begin(), separator.end());
    const int node = closeNode();
    for (int c = 0; c < count; ++c) tree_.parent[children[c]] = node;
    return node;
  }

  int closeNode() {
    tree_.parent.push_back(-1);
    tree_.nodeStart.push_back(static_cast<int>(tree_.order.size()));
    return tree_.nodeCount() - 1;
  }

  int leaf(const std::vector<int>& vertices) {
    const std::vector<int> ordered = leafOrder_.order(vertices);
    tree_.order.insert(tree_.order.end(), ordered.begin(), ordered.end());
    return closeNode();
  }

  const Graph& g_;
  const DissectionOptions& options_;
  std::vector<int> local_;
  int denseDegree_;
  LeafOrder leafOrder_;
  SeparatorTree tree_;
};

}  // namespace

SeparatorTree nestedDissection(const Graph& graph, const DissectionOptions& options) {
  HGP_CHECK(options.separatorWidth == 1 || options.separatorWidth == 2,
            "separators of width %d are not offered", options.separatorWidth);
  HGP_CHECK(options.vertexWeights.empty() ||
                static_cast<int>(options.vertexWeights.size()) == graph.size(),
            "%d weights for %d vertices", static_cast<int>(options.vertexWeights.size()),
            graph.size());
  return Dissector(graph, options).run();
}

}  // namespace hgp::linalg
