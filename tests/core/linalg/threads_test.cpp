// Every result of this module has the same bits with any number of threads.
#include "hgp/base/threads.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cstring>
#include <numeric>

#include "hgp/linalg/factor/factor.h"
#include "hgp/linalg/ordering/ordering.h"
#include "matrices.h"

namespace hgp::linalg {
namespace {

using namespace testing;

template <class Matrix>
bool sameBits(const Matrix& a, const Matrix& b) {
  return a.rows() == b.rows() && a.cols() == b.cols() &&
         std::memcmp(a.data(), b.data(), sizeof(*a.data()) * static_cast<std::size_t>(a.size())) ==
             0;
}

/// Calls `compute` with one thread, then with several, and compares.
template <class Compute, class IsSame>
void expectSame(const Compute& compute, const IsSame& isSame) {
  const auto one = [&] {
    const ThreadScope scope(1);
    return compute();
  }();
  for (const int threads : {2, 4, 7}) {
    const ThreadScope scope(threads);
    EXPECT_TRUE(isSame(one, compute())) << threads << " threads";
  }
}

// Large enough for shared dissections (4000 vertices) and several subtrees per thread.
Graph grid() { return triangulatedGrid(110, 90); }

template <class Scalar>
Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> rightHandSides(int rows, int columns) {
  Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> B(rows, columns);
  for (int c = 0; c < columns; ++c)
    for (int r = 0; r < rows; ++r) B(r, c) = Scalar(std::sin(1.0 + r + 0.3 * c));
  return B;
}

TEST(Threads, DissectionsAreTheSame) {
  for (const int width : {1, 2})
    expectSame([&] { return nestedDissection(grid(), {.separatorWidth = width}); },
               [](const SeparatorTree& a, const SeparatorTree& b) {
                 return a.order == b.order && a.nodeStart == b.nodeStart && a.parent == b.parent;
               });
}

template <class Scalar>
void expectSameSolutions() {
  const Graph graph = grid();
  const auto A = laplacian<Scalar>(graph, 0.01);
  const SeparatorTree tree = nestedDissection(graph);
  const auto B = rightHandSides<Scalar>(graph.size(), 3);
  expectSame(
      [&] {
        MultifrontalCholesky<Scalar> factor;
        factor.analyze(graph, tree);
        EXPECT_TRUE(factor.factor(A).ok);
        return factor.solve(B);
      },
      sameBits<Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>>);
}
TEST(Threads, RealSolutionsAreTheSame) { expectSameSolutions<double>(); }
TEST(Threads, ComplexSolutionsAreTheSame) { expectSameSolutions<Complex>(); }

TEST(Threads, TheFirstBadPivotIsTheSame) {
  const Graph graph = grid();
  RealSparse A = laplacian<double>(graph, 0.01);
  const SeparatorTree tree = nestedDissection(graph);
  for (const int place : {100, 5000, 7000, 9000})
    A.coeffRef(tree.order[place], tree.order[place]) = -1.0;
  const auto badPivot = [&] {
    MultifrontalCholesky<double> factor;
    factor.analyze(graph, tree);
    const FactorStatus status = factor.factor(A);
    EXPECT_FALSE(status.ok);
    return status.badPivot;
  };
  expectSame(badPivot, std::equal_to<>());
}

TEST(Threads, SchurComplementsExtensionsAndFormsAreTheSame) {
  const Graph graph = grid();
  const ComplexSparse A = laplacian<Complex>(graph, 0.01);
  const SeparatorTree tree = nestedDissection(graph);
  std::vector<int> kept, wanted;
  for (int v = 0; v < graph.size(); v += 101) kept.push_back(v);
  for (int v = 7; v < graph.size(); v += 50) wanted.push_back(v);
  FormElements elements;
  elements.count = graph.size();
  elements.unknownsOf = [&](int v, std::vector<int>& unknowns) {
    unknowns.assign(graph.begin(v), graph.end(v));
    unknowns.resize(1);
    unknowns.push_back(v);
  };
  elements.get = [&](int v, FormElements::Element& out) {
    elements.unknownsOf(v, out.unknowns);
    Eigen::RowVectorXcd row(2);
    row << std::polar(1.0, 0.7 * v), std::polar(1.3, 0.2 + v);
    out.H = row.adjoint() * row;
    out.c = -row.adjoint() * std::sin(0.1 * v);
  };
  const auto y = rightHandSides<Complex>(static_cast<int>(kept.size()), 5);
  expectSame(
      [&] {
        SchurLu lu;
        EXPECT_TRUE(lu.build(A, kept, tree).ok);
        const QuadraticForm form = lu.restrict(elements);
        const Eigen::MatrixXcd all = lu.extend(y), some = SchurExtension(lu, y).rows(wanted);
        Eigen::VectorXcd joined(lu.schur().size() + form.H.size() + form.c.size() + all.size() +
                                some.size());
        joined << lu.schur().reshaped(), form.H.reshaped(), form.c, all.reshaped(), some.reshaped();
        return joined;
      },
      sameBits<Eigen::VectorXcd>);
}

TEST(Threads, PartialFactorsAreTheSame) {
  const Graph graph = grid();
  const ComplexSparse H = laplacian<Complex>(graph, 0.01);
  Cliques cliques;
  for (int v = 0; v < graph.size(); v += 90) cliques.push_back({v, *graph.begin(v)});
  expectSame(
      [&] {
        PartialCholesky factor;
        EXPECT_TRUE(factor.build(H, cliques).ok);
        const std::vector<double> values(factor.blockStorage(), 0.0);
        EXPECT_TRUE(factor.factor(values.data()).ok);
        return factor.solve(rightHandSides<double>(2 * factor.dynamicSize(), 2));
      },
      [](const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) { return sameBits(a, b); });
}

}  // namespace
}  // namespace hgp::linalg
