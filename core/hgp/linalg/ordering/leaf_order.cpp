#include "hgp/linalg/ordering/leaf_order.h"

#include "hgp/linalg/ordering/minimum_degree.h"

namespace hgp::linalg {

LeafOrder::LeafOrder(const Graph& graph, int width, int denseDegree)
    : g_(graph),
      width_(width),
      denseDegree_(denseDegree),
      local_(static_cast<std::size_t>(graph.size()), -1) {}

// local_ numbers the leaf's vertices first, then those of its halo in the order in which they are found.
std::vector<int> LeafOrder::order(const std::vector<int>& vertices) {
  std::vector<int> named = vertices;
  for (std::size_t i = 0; i < named.size(); ++i) local_[named[i]] = static_cast<int>(i);
  std::vector<std::pair<int, int>> edges;
  const auto couple = [&](int i, int u) {
    if (local_[u] < 0) {
      local_[u] = static_cast<int>(named.size());
      named.push_back(u);
    }
    if (local_[u] != i) edges.emplace_back(i, local_[u]);
  };
  for (int i = 0; i < static_cast<int>(vertices.size()); ++i)
    for (const int* u = g_.begin(vertices[i]); u != g_.end(vertices[i]); ++u) {
      couple(i, *u);
      if (width_ < 2 || g_.degree(*u) > denseDegree_) continue;
      for (const int* w = g_.begin(*u); w != g_.end(*u); ++w) couple(i, *w);
    }
  for (const int v : named) local_[v] = -1;
  BitGraph bits(static_cast<int>(named.size()));
  for (const auto& [a, b] : edges) bits.connect(a, b);
  std::vector<int> result;
  result.reserve(vertices.size());
  for (const int i : minimumDegreeOrder(&bits, static_cast<int>(vertices.size())))
    result.push_back(vertices[i]);
  return result;
}

}  // namespace hgp::linalg
