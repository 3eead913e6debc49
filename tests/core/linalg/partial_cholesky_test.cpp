#include "hgp/linalg/factor/partial_cholesky.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "matrices.h"

namespace hgp::linalg {
namespace {

using testing::Complex;
using testing::ComplexSparse;
using testing::laplacian;
using testing::triangulatedGrid;

struct Problem {
  ComplexSparse H;
  Cliques cliques;
  std::vector<Eigen::MatrixXd> blocks;
  Eigen::VectorXcd c;
};

Problem randomProblem(const ComplexSparse& H, int cliqueCount, unsigned seed, int spread) {
  Problem p;
  p.H = H;
  std::mt19937 random(seed);
  const int n = static_cast<int>(H.rows());
  for (int b = 0; b < cliqueCount; ++b) {
    const int first = static_cast<int>(random() % static_cast<unsigned>(n));
    std::vector<int> clique{first};
    for (int k = 1; k < 3; ++k) {
      const int v = spread == 0 ? static_cast<int>(random() % static_cast<unsigned>(n))
                                : static_cast<int>((first + spread * k) % n);
      if (std::find(clique.begin(), clique.end(), v) == clique.end()) clique.push_back(v);
    }
    const int size = 2 * static_cast<int>(clique.size());
    const Eigen::MatrixXd G = Eigen::MatrixXd::Random(size, 2);
    p.blocks.push_back(G * G.transpose());
    p.cliques.push_back(clique);
  }
  p.c = Eigen::VectorXcd::Random(n);
  return p;
}

Eigen::MatrixXd realForm(const Eigen::MatrixXcd& H) {
  Eigen::MatrixXd K(2 * H.rows(), 2 * H.cols());
  for (int i = 0; i < H.rows(); ++i)
    for (int j = 0; j < H.cols(); ++j) {
      K.block<2, 2>(2 * i, 2 * j) << H(i, j).real(), -H(i, j).imag(), H(i, j).imag(),
          H(i, j).real();
    }
  return K;
}

Eigen::VectorXd realForm(const Eigen::VectorXcd& x) {
  return Eigen::Map<const Eigen::VectorXd>(reinterpret_cast<const double*>(x.data()), 2 * x.size());
}

// The minimiser of ½ xᴴHx + ½ Σ xᵀ D x + Re(cᴴx), by dense algebra.
Eigen::VectorXd denseMinimiser(const Problem& p) {
  Eigen::MatrixXd K = realForm(Eigen::MatrixXcd(p.H));
  for (std::size_t b = 0; b < p.cliques.size(); ++b)
    for (std::size_t i = 0; i < p.cliques[b].size(); ++i)
      for (std::size_t j = 0; j < p.cliques[b].size(); ++j)
        K.block<2, 2>(2 * p.cliques[b][i], 2 * p.cliques[b][j]) +=
            p.blocks[b].block<2, 2>(2 * static_cast<int>(i), 2 * static_cast<int>(j));
  return K.ldlt().solve(-realForm(p.c));
}

// The same by reduction.
void expectSameMinimiser(const Problem& p, const Eigen::VectorXd& expected,
                         const PartialCholeskyOptions& options) {
  PartialCholesky partial;
  ASSERT_TRUE(partial.build(p.H, p.cliques, options).ok);
  for (const std::vector<int>& clique : p.cliques)
    for (const int v : clique) EXPECT_GE(partial.dynamicIndex(v), 0);
  ASSERT_TRUE(partial.factor(p.blocks).ok);
  const Eigen::VectorXcd reduced = partial.reduceLinear(p.c);
  const Eigen::VectorXd xd = partial.solve(Eigen::VectorXd(-realForm(reduced)));
  const Eigen::VectorXcd x = partial.extend(xd, p.c);
  EXPECT_LE((realForm(x) - expected).norm(), 1e-9 * (1e-30 + expected.norm()));

  // apply is the matrix that factor adds the blocks to.
  Eigen::VectorXd residual = partial.apply(xd) + realForm(reduced);
  const Eigen::MatrixXcd form = partial.reducedForm();
  EXPECT_LE((realForm(form) * xd - partial.apply(xd)).norm(), 1e-12 * form.norm() * xd.norm());
  for (std::size_t b = 0; b < p.cliques.size(); ++b) {
    const int m = static_cast<int>(p.cliques[b].size());
    Eigen::VectorXd local(2 * m);
    for (int i = 0; i < m; ++i)
      local.segment<2>(2 * i) = xd.segment<2>(2 * partial.dynamicIndex(p.cliques[b][i]));
    local = p.blocks[b] * local;
    for (int i = 0; i < m; ++i)
      residual.segment<2>(2 * partial.dynamicIndex(p.cliques[b][i])) += local.segment<2>(2 * i);
  }
  EXPECT_LE(residual.norm(), 1e-9 * (1e-30 + p.c.norm()));
}

TEST(PartialCholesky, MinimisesLikeDenseAlgebraAtEveryDepth) {
  const Graph graph = triangulatedGrid(16, 12);
  const auto L = laplacian<Complex>(graph, 0.1);
  const ComplexSparse H = L.adjoint() * L;
  const SeparatorTree tree = nestedDissection(graph, {.separatorWidth = 2, .leafSize = 10});
  for (const int cliques : {1, 4, 30})
    for (const int spread : {0, 1}) {
      const Problem p = randomProblem(H, cliques, 5, spread);
      const Eigen::VectorXd expected = denseMinimiser(p);
      for (const int depth : {0, 1, 3, 100, -1}) {
        expectSameMinimiser(p, expected, {.tree = &tree, .delayDepth = depth});
        expectSameMinimiser(p, expected, {.delayDepth = depth});
      }
    }
}

TEST(PartialCholesky, WorksWithNothingOrEverythingTouched) {
  const auto H = laplacian<Complex>(triangulatedGrid(9, 8), 0.3);
  const Problem nothing = randomProblem(H, 0, 1, 0);
  expectSameMinimiser(nothing, denseMinimiser(nothing), {});
  Problem all = randomProblem(H, 0, 1, 0);
  for (int v = 0; v < H.rows(); ++v) {
    all.cliques.push_back({v});
    all.blocks.push_back(Eigen::MatrixXd::Identity(2, 2) * (1.0 + v % 5));
  }
  const Eigen::VectorXd expected = denseMinimiser(all);
  for (const int depth : {0, 2, 100}) expectSameMinimiser(all, expected, {.delayDepth = depth});
}

TEST(PartialCholesky, TouchedUnknownsMayBeSingularUntilTheirBlocksAreAdded) {
  // A Laplacian without boundary conditions: constants are its kernel; only one block pins them.
  const auto H = laplacian<double>(triangulatedGrid(12, 12), 0.0).cast<Complex>().eval();
  const Problem p = randomProblem(H, 4, 3, 0);
  Problem pinned = p;
  for (Eigen::MatrixXd& block : pinned.blocks) block.setIdentity();
  const Eigen::VectorXd expected = denseMinimiser(pinned);
  for (const int depth : {0, 2, 100}) expectSameMinimiser(pinned, expected, {.delayDepth = depth});
}

TEST(PartialCholesky, RefactorsForNewNumbers) {
  const auto H = laplacian<Complex>(triangulatedGrid(20, 20), 0.2);
  Problem p = randomProblem(H, 20, 8, 0);
  PartialCholesky partial;
  ASSERT_TRUE(partial.build(p.H, p.cliques, {}).ok);
  const Eigen::VectorXd rhs = Eigen::VectorXd::Random(2 * partial.dynamicSize());
  ASSERT_TRUE(partial.factor(p.blocks).ok);
  const Eigen::VectorXd before = partial.solve(rhs);
  for (Eigen::MatrixXd& block : p.blocks) block *= 100.0;
  ASSERT_TRUE(partial.factor(p.blocks).ok);
  EXPECT_GT((partial.solve(rhs) - before).norm(), 1e-6);
  for (Eigen::MatrixXd& block : p.blocks) block /= 100.0;
  ASSERT_TRUE(partial.factor(p.blocks).ok);
  EXPECT_LE((partial.solve(rhs) - before).norm(), 1e-12 * before.norm());
}

TEST(PartialCholesky, NamesAnUnconstrainedStaticUnknown) {
  ComplexSparse H(5, 5);
  for (const int v : {0, 1, 2, 4}) H.insert(v, v) = 1.0;
  PartialCholesky partial;
  const FactorStatus status = partial.build(H, {{0, 4}}, {});
  EXPECT_FALSE(status.ok);
  EXPECT_EQ(status.badPivot, 3);
}

TEST(PartialCholesky, ReportsBlocksThatAreNotPositive) {
  const auto H = laplacian<Complex>(triangulatedGrid(10, 10), 0.2);
  Problem p = randomProblem(H, 3, 8, 0);
  PartialCholesky partial;
  ASSERT_TRUE(partial.build(p.H, p.cliques, {}).ok);
  std::vector<Eigen::MatrixXd> bad = p.blocks;
  bad[1] = -100.0 * Eigen::MatrixXd::Identity(bad[1].rows(), bad[1].cols());
  const FactorStatus status = partial.factor(bad);
  EXPECT_FALSE(status.ok);
  EXPECT_GE(partial.dynamicIndex(status.badPivot), 0);
  bad[1](0, 0) = std::nan("");
  EXPECT_FALSE(partial.factor(bad).ok);
  EXPECT_TRUE(partial.factor(p.blocks).ok);
}

TEST(PartialCholesky, IsIndifferentToRowScaling) {
  const Graph graph = triangulatedGrid(18, 18);
  const auto L = laplacian<Complex>(graph, 0.1);
  Eigen::VectorXd weight(L.rows());
  for (int v = 0; v < L.rows(); ++v) weight[v] = std::exp(8.0 * std::sin(0.05 * v));
  const ComplexSparse rows = weight.cast<Complex>().asDiagonal() * L;
  const ComplexSparse H = rows.adjoint() * rows;
  const Problem p = randomProblem(H, 10, 4, 1);
  PartialCholesky partial;
  ASSERT_TRUE(partial.build(p.H, p.cliques, {}).ok);
  const FactorStatus status = partial.factor(p.blocks);
  ASSERT_TRUE(status.ok);
  EXPECT_EQ(status.lift, 0.0);
}

}  // namespace
}  // namespace hgp::linalg
