// Speed of the linear algebra alone: ordering, analysis, factorization, partial refactorization.
// Usage: linalg_bench [vertices …]     (default 50000 500000)
#include <cmath>
#include <complex>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <random>

#include "hgp/linalg/factor/factor.h"
#include "hgp/linalg/kernels/dense_kernels.h"

namespace {

using namespace hgp::linalg;
using Complex = std::complex<double>;

// Processor time where the clock has it: the machine may be shared.
double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// A square triangulated grid whose vertices are numbered along random stripes, about as orderly as
// a mesh file.
Graph triangulatedGrid(int side) {
  const int n = side * side;
  std::mt19937 random(1);
  std::vector<int> row(static_cast<std::size_t>(side));
  for (int i = 0; i < side; ++i) row[i] = i;
  for (int i = side - 1; i > 0; --i)
    std::swap(row[i], row[random() % static_cast<unsigned>(i + 1)]);
  const auto at = [&](int x, int y) { return row[y] * side + x; };
  std::vector<Eigen::Triplet<double>> edges;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      if (x + 1 < side) edges.emplace_back(at(x, y), at(x + 1, y), 1.0);
      if (y + 1 < side) edges.emplace_back(at(x, y), at(x, y + 1), 1.0);
      if (x + 1 == side || y + 1 == side) continue;
      if ((7 * x + 13 * y) % 3 != 0)
        edges.emplace_back(at(x, y), at(x + 1, y + 1), 1.0);
      else
        edges.emplace_back(at(x + 1, y), at(x, y + 1), 1.0);
    }
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(edges.begin(), edges.end());
  return graphOf(matrix);
}

template <class Scalar>
Eigen::SparseMatrix<Scalar> laplacian(const Graph& graph, double epsilon) {
  std::vector<Eigen::Triplet<Scalar>> entries;
  for (int v = 0; v < graph.size(); ++v) {
    entries.emplace_back(v, v, Scalar(graph.degree(v) + epsilon));
    for (const int* u = graph.begin(v); u != graph.end(v); ++u) {
      if constexpr (sizeof(Scalar) == sizeof(double))
        entries.emplace_back(v, *u, -1.0);
      else
        entries.emplace_back(v, *u, -std::polar(1.0, (v < *u ? 0.3 : -0.3) * std::sin(v + *u)));
    }
  }
  Eigen::SparseMatrix<Scalar> result(graph.size(), graph.size());
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

template <class Scalar>
void benchCholesky(const char* name, const Eigen::SparseMatrix<Scalar>& A,
                   const SeparatorTree& tree) {
  using Matrix = typename MultifrontalCholesky<Scalar>::Matrix;
  MultifrontalCholesky<Scalar> cholesky;
  double start = seconds();
  cholesky.analyze(graphOf(A), tree);
  const double analysis = seconds() - start;
  start = seconds();
  const FactorStatus status = cholesky.factor(A);
  const double factor = seconds() - start;
  const Matrix B = Matrix::Random(A.rows(), 1);
  start = seconds();
  const Matrix X = status ? cholesky.solve(B) : B;
  const double solve = seconds() - start;
  const double gflop = cholesky.cost().multiplyAdds * (sizeof(Scalar) == 8 ? 2e-9 : 8e-9);
  const double mega = 1e-6 * sizeof(Scalar);
  std::printf(
      "  %-22s analyze %.3f  factor %.3f  solve %.3f s   %.1f GFlop at %.1f GFlop/s, "
      "factor %.0f MB, peak %.0f MB, residual %.1e%s\n",
      name, analysis, factor, solve, gflop, gflop / factor,
      mega * static_cast<double>(cholesky.cost().entries),
      mega * static_cast<double>(cholesky.cost().peakEntries), (A * X - B).norm() / B.norm(),
      status ? "" : "  FAILED");
}

// Cliques of three neighbouring unknowns, clustered in groups of about eight like cones and their
// rings, until `touched` unknowns are covered.
Cliques cones(const Graph& graph, int touched, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<char> seen(static_cast<std::size_t>(graph.size()), 0);
  Cliques cliques;
  for (int covered = 0; covered < touched;) {
    const int v = static_cast<int>(random() % static_cast<unsigned>(graph.size()));
    const int degree = graph.degree(v);
    if (degree < 3) continue;
    for (int k = 0; k < degree; ++k) {
      cliques.push_back({v, graph.begin(v)[k], graph.begin(v)[(k + 1) % degree]});
      for (const int u : cliques.back()) {
        covered += !seen[u];
        seen[u] = 1;
      }
    }
  }
  return cliques;
}

void benchPartial(const Eigen::SparseMatrix<Complex>& H, const Graph& graph,
                  const SeparatorTree& tree, int touched) {
  const Cliques cliques = cones(graph, touched, 7);
  PartialCholesky partial;
  double start = seconds();
  const FactorStatus status = partial.build(H, cliques, {.tree = &tree});
  const double build = seconds() - start;
  if (!status) return;
  std::vector<double> values(partial.blockStorage(), 0.0);
  for (std::size_t b = 0; b < cliques.size(); ++b)
    for (int i = 0; i < 6; ++i)
      values[partial.blockOffset(static_cast<int>(b)) + static_cast<std::size_t>(7 * i)] = 1.0 + i;
  start = seconds();
  const int repeats = 5;
  for (int i = 0; i < repeats; ++i)
    if (!partial.factor(values.data())) std::printf("  factor failed\n");
  const double factor = (seconds() - start) / repeats;
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(2 * partial.dynamicSize());
  start = seconds();
  const Eigen::VectorXd x = partial.solve(b);
  const double solve = seconds() - start;
  start = seconds();
  const Eigen::VectorXd y = partial.apply(b);
  const double apply = seconds() - start;
  start = seconds();
  const Eigen::VectorXcd z = partial.extend(x, Eigen::VectorXcd::Zero(partial.size()));
  std::printf(
      "  touched %5d: build %.3f  factor %.4f  solve %.4f  apply %.4f  extend %.3f s   "
      "depth %d, dynamic %d, %.2f GFlop at %.1f GFlop/s per factor%s\n",
      touched, build, factor, solve, apply, seconds() - start, partial.report().delayDepth,
      partial.dynamicSize(), 2e-9 * partial.report().dynamicCost.multiplyAdds,
      2e-9 * partial.report().dynamicCost.multiplyAdds / factor,
      z.norm() * y.norm() > 0 ? "" : "  FAILED");
}

void benchLu(const Eigen::SparseMatrix<Complex>& L, const Graph& graph, const SeparatorTree& tree,
             int touched) {
  std::vector<char> seen(static_cast<std::size_t>(graph.size()), 0);
  std::vector<int> kept;
  for (const std::vector<int>& clique : cones(graph, touched, 7))
    for (const int v : clique)
      if (!seen[v]) {
        seen[v] = 1;
        kept.push_back(v);
      }
  SchurLu lu;
  double start = seconds();
  const FactorStatus status = lu.build(L, kept, tree);
  const double build = seconds() - start;
  const double gflop = 8e-9 * SchurLu::estimate(graph, kept, tree).multiplyAdds;
  start = seconds();
  if (status) lu.extend(Eigen::MatrixXcd::Ones(static_cast<int>(kept.size()), 1));
  std::printf("  LU, kept %5d: build %.3f  extend %.3f s   %.1f GFlop at %.1f GFlop/s%s\n", touched,
              build, seconds() - start, gflop, gflop / build, status ? "" : "  FAILED");
}

void benchSize(int vertices) {
  const int side = static_cast<int>(std::sqrt(static_cast<double>(vertices)));
  const Graph graph = triangulatedGrid(side);
  double start = seconds();
  const SeparatorTree narrow = nestedDissection(graph);
  const double narrowTime = seconds() - start;
  start = seconds();
  const SeparatorTree wide = nestedDissection(graph, {.separatorWidth = 2});
  std::printf("%d vertices: dissection %.3f s, with separators of width two %.3f s; kernels: %s\n",
              graph.size(), narrowTime, seconds() - start, kernels().name);
  benchCholesky("real Laplacian", laplacian<double>(graph, 0.01), narrow);
  const Eigen::SparseMatrix<Complex> L = laplacian<Complex>(graph, 0.01);
  benchCholesky("complex Laplacian", L, narrow);
  for (const int touched : {60, 500}) benchLu(L, graph, narrow, touched);
  const Eigen::SparseMatrix<Complex> H = L.adjoint() * L;
  benchCholesky("complex squared", H, wide);
  for (const int touched : {60, 500, 4000}) benchPartial(H, graph, wide, touched);
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 2) {
    for (const int vertices : {50000, 500000}) benchSize(vertices);
  }
  for (int i = 1; i < count; ++i) benchSize(std::atoi(arguments[i]));
  return 0;
}
