#include "hgp/linalg/ordering/minimum_degree.h"

#include <bit>

namespace hgp::linalg {
namespace {

int degreeOf(const std::uint64_t* row, int words) {
  int degree = 0;
  for (int w = 0; w < words; ++w) degree += std::popcount(row[w]);
  return degree;
}

void eliminate(BitGraph* graph, int v, int count, std::vector<int>* degree) {
  const int words = graph->words();
  std::uint64_t* pivot = graph->row(v);
  for (int w = 0; w < words; ++w)
    for (std::uint64_t left = pivot[w]; left != 0; left &= left - 1) {
      const int u = 64 * w + std::countr_zero(left);
      std::uint64_t* row = graph->row(u);
      for (int k = 0; k < words; ++k) row[k] |= pivot[k];
      row[u >> 6] &= ~(std::uint64_t{1} << (u & 63));
      row[v >> 6] &= ~(std::uint64_t{1} << (v & 63));
      if (u < count) (*degree)[u] = degreeOf(row, words);
    }
}

}  // namespace

std::vector<int> minimumDegreeOrder(BitGraph* graph, int count) {
  std::vector<int> order, left, degree(static_cast<std::size_t>(count));
  order.reserve(static_cast<std::size_t>(count));
  for (int v = 0; v < count; ++v) {
    left.push_back(v);
    degree[v] = degreeOf(graph->row(v), graph->words());
  }
  while (!left.empty()) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < left.size(); ++i) {
      const int a = left[i], b = left[best];
      if (degree[a] < degree[b] || (degree[a] == degree[b] && a < b)) best = i;
    }
    const int v = left[best];
    left[best] = left.back();
    left.pop_back();
    order.push_back(v);
    eliminate(graph, v, count, &degree);
  }
  return order;
}

}  // namespace hgp::linalg
