// Graphs and matrices for the tests of this module.
#pragma once

#include <Eigen/SparseCore>
#include <complex>
#include <random>
#include <vector>

#include "hgp/linalg/graph/graph.h"

namespace hgp::linalg::testing {

using Complex = std::complex<double>;
using RealSparse = Eigen::SparseMatrix<double>;
using ComplexSparse = Eigen::SparseMatrix<Complex>;

inline Graph graphFromEdges(int n, const std::vector<std::pair<int, int>>& edges) {
  std::vector<Eigen::Triplet<double>> triplets;
  for (const auto& [a, b] : edges) triplets.emplace_back(a, b, 1.0);
  RealSparse matrix(n, n);
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  return graphOf(matrix);
}

/// width × height vertices, each square split by one of its diagonals; vertices shuffled.
inline Graph triangulatedGrid(int width, int height, unsigned seed = 1) {
  const int n = width * height;
  std::vector<int> name(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) name[i] = i;
  std::mt19937 random(seed);
  for (int i = n - 1; i > 0; --i) std::swap(name[i], name[random() % static_cast<unsigned>(i + 1)]);
  std::vector<std::pair<int, int>> edges;
  const auto at = [&](int x, int y) { return name[y * width + x]; };
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      if (x + 1 < width) edges.emplace_back(at(x, y), at(x + 1, y));
      if (y + 1 < height) edges.emplace_back(at(x, y), at(x, y + 1));
      if (x + 1 == width || y + 1 == height) continue;
      if ((7 * x + 13 * y) % 3 == 0)
        edges.emplace_back(at(x + 1, y), at(x, y + 1));
      else
        edges.emplace_back(at(x, y), at(x + 1, y + 1));
    }
  return graphFromEdges(n, edges);
}

inline Graph randomGraph(int n, int edgeCount, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<std::pair<int, int>> edges;
  for (int e = 0; e < edgeCount; ++e) {
    const int a = static_cast<int>(random() % static_cast<unsigned>(n));
    const int b = static_cast<int>(random() % static_cast<unsigned>(n));
    if (a != b) edges.emplace_back(a, b);
  }
  return graphFromEdges(n, edges);
}

inline double weightOf(int a, int b) {
  return 1.0 + 0.5 * std::sin(3.0 * std::min(a, b) + std::max(a, b));
}

/// Weighted graph Laplacian + ε; for complex numbers each edge also rotates.
template <class Scalar>
Eigen::SparseMatrix<Scalar> laplacian(const Graph& graph, double epsilon) {
  std::vector<Eigen::Triplet<Scalar>> triplets;
  for (int v = 0; v < graph.size(); ++v) {
    double sum = epsilon;
    for (const int* u = graph.begin(v); u != graph.end(v); ++u) {
      const double w = weightOf(v, *u);
      sum += w;
      if constexpr (sizeof(Scalar) == sizeof(double))
        triplets.emplace_back(v, *u, -w);
      else
        triplets.emplace_back(v, *u, -std::polar(w, (v < *u ? 1 : -1) * 0.4 * std::sin(v + *u)));
    }
    triplets.emplace_back(v, v, Scalar(sum));
  }
  Eigen::SparseMatrix<Scalar> result(graph.size(), graph.size());
  result.setFromTriplets(triplets.begin(), triplets.end());
  return result;
}

/// Families every law is tried on: empty, tiny, disconnected, star, path, complete, random, meshes.
inline std::vector<Graph> allGraphs() {
  std::vector<Graph> graphs;
  graphs.push_back(Graph{});
  graphs.push_back(graphFromEdges(1, {}));
  graphs.push_back(graphFromEdges(2, {{0, 1}}));
  graphs.push_back(graphFromEdges(200, {}));
  std::vector<std::pair<int, int>> star, path, complete;
  for (int i = 1; i < 300; ++i) star.emplace_back(0, i);
  for (int i = 1; i < 400; ++i) path.emplace_back(i - 1, i);
  for (int i = 0; i < 90; ++i)
    for (int j = 0; j < i; ++j) complete.emplace_back(i, j);
  graphs.push_back(graphFromEdges(300, star));
  graphs.push_back(graphFromEdges(400, path));
  graphs.push_back(graphFromEdges(90, complete));
  graphs.push_back(randomGraph(240, 180, 2));  // mostly disconnected
  graphs.push_back(randomGraph(300, 750, 3));  // an expander: large separators
  graphs.push_back(triangulatedGrid(12, 7));
  graphs.push_back(triangulatedGrid(31, 26));
  return graphs;
}

}  // namespace hgp::linalg::testing
