#include "hgp/linalg/factor/multifrontal.h"

#include <gtest/gtest.h>

#include <Eigen/SparseCholesky>

#include "matrices.h"

namespace hgp::linalg {
namespace {

using testing::allGraphs;
using testing::Complex;
using testing::laplacian;
using testing::triangulatedGrid;

template <class Scalar>
using Dense = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

template <class Scalar>
void expectSolves(const Eigen::SparseMatrix<Scalar>& A, const SeparatorTree& tree) {
  MultifrontalCholesky<Scalar> cholesky;
  cholesky.analyze(graphOf(A), tree);
  ASSERT_TRUE(cholesky.factor(A).ok);
  const Dense<Scalar> B = Dense<Scalar>::Random(A.rows(), 3);
  const Dense<Scalar> X = cholesky.solve(B);
  ASSERT_EQ(X.rows(), A.rows());
  EXPECT_LE((A * X - B).norm(), 1e-10 * (1 + B.norm()));
}

TEST(MultifrontalCholesky, SolvesOnEveryGraphFamily) {
  for (const Graph& graph : allGraphs()) {
    const SeparatorTree tree = nestedDissection(graph, {.leafSize = 25});
    expectSolves(laplacian<double>(graph, 0.1), tree);
    expectSolves(laplacian<Complex>(graph, 0.1), tree);
  }
}

TEST(MultifrontalCholesky, SolvesSquaredLaplaciansOrderedByTheOneRing) {
  const Graph graph = triangulatedGrid(60, 41);
  const auto L = laplacian<Complex>(graph, 0.1);
  const Eigen::SparseMatrix<Complex> A = L.adjoint() * L;
  expectSolves(A, nestedDissection(graph, {.separatorWidth = 2}));
}

TEST(MultifrontalCholesky, AgreesWithTheSimplicialSolver) {
  const Graph graph = triangulatedGrid(70, 50);
  const auto A = laplacian<double>(graph, 1e-3);
  MultifrontalCholesky<double> cholesky;
  cholesky.analyze(graphOf(A), nestedDissection(graph));
  ASSERT_TRUE(cholesky.factor(A).ok);
  const Eigen::MatrixXd B = Eigen::MatrixXd::Random(A.rows(), 7);
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> reference(A);
  const Eigen::MatrixXd expected = reference.solve(B);
  EXPECT_LE((cholesky.solve(B) - expected).norm(), 1e-10 * expected.norm());
}

template <class Scalar>
void expectColumnsOneByOne() {
  const Graph graph = triangulatedGrid(40, 30);
  const auto A = laplacian<Scalar>(graph, 0.1);
  MultifrontalCholesky<Scalar> cholesky;
  cholesky.analyze(graphOf(A), nestedDissection(graph));
  ASSERT_TRUE(cholesky.factor(A).ok);
  const Dense<Scalar> B = Dense<Scalar>::Random(A.rows(), 11);
  const Dense<Scalar> X = cholesky.solve(B);
  for (Eigen::Index c = 0; c < B.cols(); ++c)
    EXPECT_TRUE(X.col(c) == cholesky.solve(B.col(c))) << "column " << c;
}

TEST(MultifrontalCholesky, SolvesSeveralColumnsWithTheBitsOfEach) {
  expectColumnsOneByOne<double>();
  expectColumnsOneByOne<Complex>();
}

TEST(MultifrontalCholesky, ShiftAddsToTheDiagonal) {
  const Graph graph = triangulatedGrid(20, 20);
  const auto A = laplacian<double>(graph, 0.5), shifted = laplacian<double>(graph, 2.0);
  const SeparatorTree tree = nestedDissection(graph);
  MultifrontalCholesky<double> a, b;
  a.analyze(graphOf(A), tree);
  b.analyze(graphOf(A), tree);
  ASSERT_TRUE(a.factor(A, 1.5).ok);
  ASSERT_TRUE(b.factor(shifted).ok);
  const Eigen::MatrixXd B = Eigen::MatrixXd::Random(A.rows(), 2);
  EXPECT_LE((a.solve(B) - b.solve(B)).norm(), 1e-12 * B.norm());
}

TEST(MultifrontalCholesky, RefusesSingularAndIndefiniteMatricesAndRecovers) {
  const Graph graph = triangulatedGrid(30, 30);
  const auto good = laplacian<double>(graph, 0.1);
  MultifrontalCholesky<double> cholesky;
  cholesky.analyze(graphOf(good), nestedDissection(graph));
  Eigen::SparseMatrix<double> bad = good;
  bad.coeffRef(417, 417) = -1.0;
  const FactorStatus status = cholesky.factor(bad);
  EXPECT_FALSE(status.ok);
  EXPECT_GE(status.badPivot, 0);
  EXPECT_FALSE(cholesky.isFactored());
  EXPECT_TRUE(cholesky.factor(good).ok);
  EXPECT_FALSE(cholesky.factor(laplacian<double>(graph, 0.0)).ok);  // constants are its kernel
}

TEST(MultifrontalCholesky, NamesAnUnconstrainedUnknown) {
  Eigen::SparseMatrix<double> A(3, 3);
  A.insert(0, 0) = 1.0;
  A.insert(2, 2) = 1.0;
  MultifrontalCholesky<double> cholesky;
  cholesky.analyze(graphOf(A), nestedDissection(graphOf(A)));
  const FactorStatus status = cholesky.factor(A);
  EXPECT_FALSE(status.ok);
  EXPECT_EQ(status.badPivot, 1);
}

TEST(MultifrontalCholesky, IsIndifferentToDiagonalScaling) {
  const Graph graph = triangulatedGrid(40, 40);
  const auto A = laplacian<Complex>(graph, 0.1);
  Eigen::VectorXd scale(A.rows());
  for (int v = 0; v < A.rows(); ++v) scale[v] = std::pow(10.0, 10.0 * std::sin(1.7 * v));
  const Eigen::SparseMatrix<Complex> scaled =
      scale.cast<Complex>().asDiagonal() * A * scale.cast<Complex>().asDiagonal();
  MultifrontalCholesky<Complex> cholesky;
  cholesky.analyze(graphOf(A), nestedDissection(graph));
  ASSERT_TRUE(cholesky.factor(scaled).ok);
  const Eigen::MatrixXcd x = Eigen::MatrixXcd::Random(A.rows(), 1);
  const Eigen::MatrixXcd b = scale.cast<Complex>().asDiagonal() * (A * x);
  const Eigen::MatrixXcd y = cholesky.solve(b);  // = scale⁻¹ x
  EXPECT_LE((scale.cast<Complex>().asDiagonal() * y - x).norm(), 1e-10 * x.norm());
}

TEST(SymbolicFactor, CountsAgreeWithDenseElimination) {
  for (const Graph& graph : allGraphs()) {
    if (graph.size() > 800) continue;
    const std::vector<int> order = nestedDissection(graph, {.leafSize = 25}).order;
    const SymbolicFactor f = analyze(graph, order, {.amalgamate = false});
    const int n = f.size();
    Eigen::Matrix<bool, Eigen::Dynamic, Eigen::Dynamic> fill(n, n);
    fill.setConstant(false);
    for (int v = 0; v < n; ++v)
      for (const int* u = graph.begin(v); u != graph.end(v); ++u)
        fill(f.position[v], f.position[*u]) = true;
    for (int k = 0; k < n; ++k) {
      std::vector<int> rows;
      for (int i = k + 1; i < n; ++i)
        if (fill(i, k)) rows.push_back(i);
      for (const int i : rows)
        for (const int j : rows) fill(i, j) = true;
    }
    for (int t = 0; t < f.nodeCount(); ++t)
      for (int k = f.nodeStart[t]; k < f.nodeStart[t + 1]; ++k) {
        int count = 0;
        for (int i = k + 1; i < n; ++i) count += fill(i, k);
        EXPECT_EQ(count, f.nodeStart[t + 1] - k - 1 + f.rowCount(t));
      }
  }
}

TEST(SymbolicFactor, AmalgamationOnlyAddsRows) {
  const Graph graph = triangulatedGrid(50, 50);
  const std::vector<int> order = nestedDissection(graph).order;
  const FactorCost exact = factorCost(analyze(graph, order, {.amalgamate = false}));
  const FactorCost merged = factorCost(analyze(graph, order));
  EXPECT_GE(merged.entries, exact.entries);
  EXPECT_LE(static_cast<double>(merged.entries), 3.0 * static_cast<double>(exact.entries));
}

}  // namespace
}  // namespace hgp::linalg
