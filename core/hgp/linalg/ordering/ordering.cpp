#include "hgp/linalg/ordering/ordering.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <mutex>

#include "hgp/base/check.h"
#include "hgp/base/parallel.h"
#include "hgp/linalg/ordering/bisection.h"
#include "hgp/linalg/ordering/leaf_order.h"

namespace hgp::linalg {
namespace {

/// Parts of more vertices are shared among threads.
constexpr std::size_t kShared = 4000;

/// Appends a tree whose nodes follow those of `tree`; its root stays one.
void append(const SeparatorTree& piece, SeparatorTree& tree) {
  const int nodes = tree.nodeCount(), vertices = static_cast<int>(tree.order.size());
  tree.order.insert(tree.order.end(), piece.order.begin(), piece.order.end());
  for (const int p : piece.parent) tree.parent.push_back(p < 0 ? -1 : p + nodes);
  for (std::size_t t = 1; t < piece.nodeStart.size(); ++t)
    tree.nodeStart.push_back(piece.nodeStart[t] + vertices);
}

class Dissector {
 public:
  Dissector(const Graph& graph, const DissectionOptions& options)
      : g_(graph), options_(options), denseDegree_(denseDegree(graph.size())) {}

  SeparatorTree run() {
    std::vector<int> dense;
    SeparatorTree tree = dissect(wholeGraph(&dense));
    // Vertices of extreme degree would enlarge every cut; eliminated last, each costs one row of each panel.
    tree.order.insert(tree.order.end(), dense.begin(), dense.end());
    tree.nodeStart.back() += static_cast<int>(dense.size());
    return tree;
  }

 private:
  /// Of one thread; as many as are used at a time.
  struct Scratch {
    Scratch(const Graph& graph, int width, int denseDegree)
        : local(static_cast<std::size_t>(graph.size()), -1), leaf(graph, width, denseDegree) {}
    std::vector<int> local;
    LeafOrder leaf;
  };
  struct Halves {
    Part first, second;
    std::vector<int> separator;
    bool isCut = true;
  };

  template <class Use>
  auto withScratch(const Use& use) {
    std::unique_ptr<Scratch> mine;
    {
      const std::lock_guard lock(mutex_);
      if (!free_.empty()) {
        mine = std::move(free_.back());
        free_.pop_back();
      }
    }
    if (!mine) mine = std::make_unique<Scratch>(g_, options_.separatorWidth, denseDegree_);
    auto result = use(*mine);
    const std::lock_guard lock(mutex_);
    free_.push_back(std::move(mine));
    return result;
  }

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
    std::vector<int> keep = breadthFirst(), local(static_cast<std::size_t>(n), -1);
    for (int v = 0; v < n; ++v)
      if (g_.degree(v) > denseDegree_) dense->push_back(v);
    for (std::size_t i = 0; i < keep.size(); ++i) local[keep[i]] = static_cast<int>(i);
    Part part;
    part.graph.neighbours.reserve(g_.neighbours.size());
    for (const int v : keep) {
      for (const int* u = g_.begin(v); u != g_.end(v); ++u)
        if (local[*u] >= 0) part.graph.neighbours.push_back(local[*u]);
      part.graph.start.push_back(static_cast<int>(part.graph.neighbours.size()));
      part.graph.vertexWeight.push_back(weightOf(v));
    }
    part.graph.edgeWeight.assign(part.graph.neighbours.size(), 1);
    part.vertex = std::move(keep);
    return part;
  }

  Halves cut(Part part, Scratch& scratch) const {
    Halves out;
    std::vector<char> side = bisect(&part, options_.imbalance);
    coverCut(g_, part, options_.separatorWidth, &scratch.local, &side);
    for (int v = 0; v < part.graph.size(); ++v)
      if (side[v] == 2) out.separator.push_back(part.vertex[v]);
    const auto takeFirst = [&] { out.first = subPart(part, side, 0); };
    const auto takeSecond = [&] { out.second = subPart(part, side, 1); };
    if (part.vertex.size() > kShared && threadCount() > 1) {
      parallelInvoke({takeFirst, takeSecond});
    } else {
      takeFirst();
      takeSecond();
    }
    const std::size_t largest = std::max(out.first.vertex.size(), out.second.vertex.size());
    out.isCut = largest < part.vertex.size();
    if (!out.isCut) out.first = std::move(part);
    return out;
  }

  /// The tree of a part. Nodes are numbered as they would be finished by one thread: postorder.
  SeparatorTree dissect(Part part) {
    SeparatorTree tree;
    tree.nodeStart.push_back(0);
    if (part.vertex.size() <= kShared || threadCount() == 1) {
      tree.order.reserve(part.vertex.size());
      const int root = withScratch(
          [&](Scratch& scratch) { return dissectInto(tree, std::move(part), scratch); });
      HGP_CHECK(root + 1 == tree.nodeCount(), "root is node %d of %d", root, tree.nodeCount());
      return tree;
    }
    Halves halves = withScratch([&](Scratch& scratch) { return cut(std::move(part), scratch); });
    if (!halves.isCut) {
      withScratch([&](Scratch& scratch) { return leaf(tree, halves.first.vertex, scratch); });
      return tree;
    }
    SeparatorTree first, second;
    std::vector<std::function<void()>> works;
    if (!halves.first.vertex.empty())
      works.emplace_back([&] { first = dissect(std::move(halves.first)); });
    if (!halves.second.vertex.empty())
      works.emplace_back([&] { second = dissect(std::move(halves.second)); });
    parallelInvoke(works);
    append(first, tree);
    const int a = tree.nodeCount() - 1;
    append(second, tree);
    const int b = tree.nodeCount() - 1;
    close(tree, halves.separator, a, b == a ? -1 : b);
    return tree;
  }

  /// The same by this thread, appended to a tree. Returns the node at the top.
  int dissectInto(SeparatorTree& tree, Part part, Scratch& scratch) const {
    if (part.graph.size() <= options_.leafSize) return leaf(tree, part.vertex, scratch);
    Halves halves = cut(std::move(part), scratch);
    if (!halves.isCut) return leaf(tree, halves.first.vertex, scratch);  // nothing to cut
    int first = -1, second = -1;
    if (!halves.first.vertex.empty()) first = dissectInto(tree, std::move(halves.first), scratch);
    if (!halves.second.vertex.empty())
      second = dissectInto(tree, std::move(halves.second), scratch);
    return close(tree, halves.separator, first, second);
  }

  /// Ends a node with these vertices above two others, −1: none.
  static int close(SeparatorTree& tree, const std::vector<int>& vertices, int first, int second) {
    tree.order.insert(tree.order.end(), vertices.begin(), vertices.end());
    const int node = tree.nodeCount();
    tree.parent.push_back(-1);
    tree.nodeStart.push_back(static_cast<int>(tree.order.size()));
    if (first >= 0) tree.parent[first] = node;
    if (second >= 0) tree.parent[second] = node;
    return node;
  }

  static int leaf(SeparatorTree& tree, const std::vector<int>& vertices, Scratch& scratch) {
    return close(tree, scratch.leaf.order(vertices), -1, -1);
  }

  const Graph& g_;
  const DissectionOptions& options_;
  int denseDegree_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Scratch>> free_;
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
