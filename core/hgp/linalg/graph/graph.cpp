#include "hgp/linalg/graph/graph.h"

#include <algorithm>
#include <complex>

#include "hgp/base/check.h"

namespace hgp::linalg {
namespace {

// Bucket sort of half-edges, followed by removal of duplicates within each list.
Graph graphFromLists(int n, const std::vector<int>& count, const auto& forEachEdge) {
  Graph g;
  g.start.assign(static_cast<std::size_t>(n) + 1, 0);
  for (int v = 0; v < n; ++v) g.start[v + 1] = g.start[v] + count[v];
  g.neighbours.resize(static_cast<std::size_t>(g.start[n]));
  std::vector<int> next(g.start.begin(), g.start.end() - 1);
  forEachEdge([&](int a, int b) {
    g.neighbours[next[a]++] = b;
    g.neighbours[next[b]++] = a;
  });
  std::vector<int> seen(static_cast<std::size_t>(n), -1);
  int out = 0;
  for (int v = 0; v < n; ++v) {
    const int from = g.start[v], to = g.start[v + 1];
    g.start[v] = out;
    for (int e = from; e < to; ++e) {
      const int u = g.neighbours[e];
      if (seen[u] == v) continue;
      seen[u] = v;
      g.neighbours[out++] = u;
    }
  }
  g.start[n] = out;
  g.neighbours.resize(static_cast<std::size_t>(out));
  return g;
}

}  // namespace

template <class Scalar>
Graph graphOf(const Eigen::SparseMatrix<Scalar>& matrix) {
  HGP_CHECK(matrix.rows() == matrix.cols(), "pattern is %d × %d, need square",
            static_cast<int>(matrix.rows()), static_cast<int>(matrix.cols()));
  const int n = static_cast<int>(matrix.cols());
  const auto forEachEdge = [&](auto&& take) {
    for (int j = 0; j < n; ++j)
      for (typename Eigen::SparseMatrix<Scalar>::InnerIterator it(matrix, j); it; ++it)
        if (it.row() != j) take(static_cast<int>(it.row()), j);
  };
  std::vector<int> count(static_cast<std::size_t>(n), 0);
  forEachEdge([&](int i, int j) {
    ++count[i];
    ++count[j];
  });
  return graphFromLists(n, count, forEachEdge);
}

template Graph graphOf(const Eigen::SparseMatrix<double>&);
template Graph graphOf(const Eigen::SparseMatrix<std::complex<double>>&);

Graph graphOf(int vertexCount, const std::vector<std::array<int, 2>>& edges) {
  std::vector<int> count(static_cast<std::size_t>(vertexCount), 0);
  const auto forEachEdge = [&](auto&& take) {
    for (const auto& [a, b] : edges) take(a, b);
  };
  forEachEdge([&](int a, int b) {
    ++count[a];
    ++count[b];
  });
  return graphFromLists(vertexCount, count, forEachEdge);
}

Graph withCliques(const Graph& graph, const Cliques& cliques) {
  const int n = graph.size();
  const auto forEachEdge = [&](auto&& take) {
    for (int v = 0; v < n; ++v)
      for (const int* u = graph.begin(v); u != graph.end(v); ++u)
        if (*u > v) take(v, *u);
    for (const std::vector<int>& clique : cliques)
      for (std::size_t i = 0; i < clique.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) take(clique[i], clique[j]);
  };
  std::vector<int> count(static_cast<std::size_t>(n), 0);
  forEachEdge([&](int a, int b) {
    ++count[a];
    ++count[b];
  });
  return graphFromLists(n, count, forEachEdge);
}

}  // namespace hgp::linalg
