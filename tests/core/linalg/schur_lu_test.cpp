#include "hgp/linalg/factor/schur_lu.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "hgp/linalg/factor/schur_extension.h"
#include "matrices.h"

namespace hgp::linalg {
namespace {

using testing::allGraphs;
using testing::Complex;
using testing::ComplexSparse;
using testing::triangulatedGrid;

// Weakly diagonally dominant rows with rotations and unequal weights in the two directions.
ComplexSparse dominantRows(const Graph& graph, double excess) {
  std::vector<Eigen::Triplet<Complex>> entries;
  for (int v = 0; v < graph.size(); ++v) {
    double sum = excess;
    for (const int* u = graph.begin(v); u != graph.end(v); ++u) {
      const double w = 1.0 + 0.9 * std::sin(7.0 * v + 3.0 * *u);
      sum += w;
      entries.emplace_back(v, *u, -std::polar(w, 1.3 * std::sin(v + 2.0 * *u)));
    }
    entries.emplace_back(v, v, std::polar(sum, 0.3 * v));
  }
  ComplexSparse A(graph.size(), graph.size());
  A.setFromTriplets(entries.begin(), entries.end());
  return A;
}

std::vector<int> everyKth(int n, int k) {
  std::vector<int> kept;
  for (int v = n - 1; v >= 0; v -= k) kept.push_back(v);
  return kept;
}

TEST(SchurLu, ExtensionMakesEliminatedRowsVanishAndSchurGivesTheOthers) {
  for (const Graph& graph : allGraphs())
    for (const int k : {1, 7, 90}) {
      const ComplexSparse A = dominantRows(graph, 0.01);
      const std::vector<int> kept = everyKth(graph.size(), k);
      SchurLu lu;
      ASSERT_TRUE(lu.build(A, kept, nestedDissection(graph, {.leafSize = 25})).ok);
      const Eigen::MatrixXcd xk = Eigen::MatrixXcd::Random(static_cast<int>(kept.size()), 2);
      const Eigen::MatrixXcd x = lu.extend(xk), residual = A * x;
      const Eigen::MatrixXcd expected = lu.schur() * xk;
      std::vector<char> isKept(static_cast<std::size_t>(graph.size()), 0);
      for (std::size_t i = 0; i < kept.size(); ++i) {
        isKept[kept[i]] = 1;
        const int row = static_cast<int>(i);
        EXPECT_LT((x.row(kept[i]) - xk.row(row)).norm(), 1e-15);
        EXPECT_LT((residual.row(kept[i]) - expected.row(row)).norm(), 1e-9);
      }
      for (int v = 0; v < graph.size(); ++v) {
        if (!isKept[v]) {
          EXPECT_LT(residual.row(v).norm(), 1e-10) << v;
        }
      }
    }
}

TEST(SchurLu, AgreesWithDenseAlgebra) {
  const Graph graph = triangulatedGrid(14, 11);
  const ComplexSparse A = dominantRows(graph, 0.0);
  const std::vector<int> kept{5, 100, 17, 60};
  SchurLu lu;
  ASSERT_TRUE(lu.build(A, kept, nestedDissection(graph, {.leafSize = 10})).ok);
  const Eigen::MatrixXcd inverse = Eigen::MatrixXcd(A).inverse();
  Eigen::MatrixXcd block(4, 4);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) block(i, j) = inverse(kept[i], kept[j]);
  EXPECT_LT((lu.schur() * block - Eigen::MatrixXcd::Identity(4, 4)).norm(), 1e-10);
}

TEST(SchurLu, ExtensionToSomeUnknownsIsTheSame) {
  for (const Graph& graph : allGraphs()) {
    const ComplexSparse A = dominantRows(graph, 0.01);
    const std::vector<int> kept = everyKth(graph.size(), 20), wanted = everyKth(graph.size(), 13);
    SchurLu lu;
    ASSERT_TRUE(lu.build(A, kept, nestedDissection(graph, {.leafSize = 25})).ok);
    const Eigen::MatrixXcd xk = Eigen::MatrixXcd::Random(static_cast<int>(kept.size()), 3);
    const Eigen::MatrixXcd all = lu.extend(xk);
    SchurExtension extension(lu, xk);
    // Few first, so that later calls find some nodes visited and others not; kept unknowns are given.
    std::vector<std::vector<int>> calls = {{}, kept, wanted, wanted};
    if (!wanted.empty()) calls.insert(calls.begin(), {wanted.back()});
    for (const std::vector<int>& unknowns : calls) {
      const Eigen::MatrixXcd some = extension.rows(unknowns);
      ASSERT_EQ(some.rows(), static_cast<int>(unknowns.size()));
      for (std::size_t i = 0; i < unknowns.size(); ++i)
        EXPECT_EQ(all.row(unknowns[i]), some.row(static_cast<int>(i)));
    }
  }
}

TEST(SchurLu, ExtensionOfManyColumnsHasTheBitsOfEachAlone) {
  const Graph graph = triangulatedGrid(14, 11);
  const std::vector<int> kept = everyKth(graph.size(), 20);
  SchurLu lu;
  ASSERT_TRUE(
      lu.build(dominantRows(graph, 0.01), kept, nestedDissection(graph, {.leafSize = 25})).ok);
  const Eigen::MatrixXcd xk = Eigen::MatrixXcd::Random(static_cast<int>(kept.size()), 11);
  const Eigen::MatrixXcd all = lu.extend(xk);
  for (int c = 0; c < xk.cols(); ++c)
    EXPECT_EQ(all.col(c), lu.extend(Eigen::MatrixXcd(xk.col(c))).col(0)) << c;
}

/// |row · x − target|² for every edge of the graph and every vertex.
FormElements edgeTerms(const Graph& graph, std::vector<std::vector<int>>& unknowns) {
  for (int v = 0; v < graph.size(); ++v) {
    unknowns.push_back({v});
    for (const int* u = graph.begin(v); u != graph.end(v); ++u) unknowns.push_back({*u, v});
  }
  FormElements elements;
  elements.count = static_cast<int>(unknowns.size());
  elements.unknownsOf = [&unknowns](int e, std::vector<int>& out) {
    out = unknowns[static_cast<std::size_t>(e)];
  };
  elements.get = [&unknowns](int e, FormElements::Element& out) {
    out.unknowns = unknowns[static_cast<std::size_t>(e)];
    Eigen::RowVectorXcd row(static_cast<int>(out.unknowns.size()));
    for (int i = 0; i < row.size(); ++i) row[i] = std::polar(1.0 + 0.3 * i, 0.7 * e + i);
    out.H = row.adjoint() * row;
    out.c = -row.adjoint() * std::sin(0.1 * e);
  };
  return elements;
}

TEST(SchurLu, RestrictedFormsHaveTheValuesOfTheFormOnExtensions) {
  for (const Graph& graph : allGraphs())
    for (const int k : {1, 7, 90}) {
      const ComplexSparse A = dominantRows(graph, 0.01);
      const std::vector<int> kept = everyKth(graph.size(), k);
      SchurLu lu;
      ASSERT_TRUE(lu.build(A, kept, nestedDissection(graph, {.leafSize = 25})).ok);
      std::vector<std::vector<int>> unknowns;
      const FormElements elements = edgeTerms(graph, unknowns);
      const QuadraticForm form = lu.restrict(elements);
      const Eigen::VectorXcd xk = Eigen::VectorXcd::Random(static_cast<int>(kept.size()));
      const Eigen::MatrixXcd x = lu.extend(Eigen::MatrixXcd(xk));
      double expected = 0.0;
      FormElements::Element element;
      for (int e = 0; e < elements.count; ++e) {
        elements.get(e, element);
        Eigen::VectorXcd at(static_cast<int>(element.unknowns.size()));
        for (int i = 0; i < at.size(); ++i) at[i] = x(element.unknowns[i], 0);
        expected += (at.dot(element.H * at) + 2.0 * element.c.dot(at)).real();
      }
      const double value = (xk.dot(form.H * xk) + 2.0 * form.c.dot(xk)).real();
      EXPECT_NEAR(value, expected, 1e-10 * (1.0 + std::abs(expected))) << graph.size() << " " << k;
    }
}

TEST(SchurLu, NamesAnEmptyRow) {
  ComplexSparse A(4, 4);
  A.insert(0, 0) = 1.0;
  A.insert(1, 1) = 1.0;
  A.insert(3, 3) = 1.0;
  SchurLu lu;
  const FactorStatus status = lu.build(A, {0}, nestedDissection(graphOf(A)));
  EXPECT_FALSE(status.ok);
  EXPECT_EQ(status.badPivot, 2);
  EXPECT_TRUE(lu.build(A, {2}, nestedDissection(graphOf(A))).ok);
}

TEST(SchurLu, EstimateGrowsWithTheTouchedUnknowns) {
  const Graph graph = triangulatedGrid(40, 40);
  const SeparatorTree tree = nestedDissection(graph);
  const FactorCost few = SchurLu::estimate(graph, everyKth(1600, 400), tree);
  const FactorCost many = SchurLu::estimate(graph, everyKth(1600, 10), tree);
  EXPECT_GT(few.multiplyAdds, 0);
  EXPECT_GT(many.multiplyAdds, few.multiplyAdds);
}

}  // namespace
}  // namespace hgp::linalg
