#include "hgp/linalg/factor/real_partial.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "matrices.h"

namespace hgp::linalg {
namespace {

using testing::RealSparse;

struct RealProblem {
  RealSparse H;
  Cliques cliques;
  Eigen::VectorXd c;
};

RealProblem randomRealProblem(int cliqueCount, unsigned seed) {
  RealProblem p;
  p.H = testing::laplacian<double>(testing::triangulatedGrid(17, 13, seed), 0.01);
  const int n = static_cast<int>(p.H.rows());
  std::mt19937 random(seed);
  for (int b = 0; b < cliqueCount; ++b) {
    const int first = static_cast<int>(random() % static_cast<unsigned>(n));
    p.cliques.push_back({first, (first + 1) % n, (first + 40) % n});
  }
  p.c = Eigen::VectorXd::Random(n);
  return p;
}

/// Σ GGᵀ on the cliques, `weight` times.
RealSparse blocksOf(const RealProblem& p, double weight) {
  std::vector<Eigen::Triplet<double>> entries;
  for (const std::vector<int>& clique : p.cliques) {
    const Eigen::VectorXd g = Eigen::VectorXd::Random(3);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        entries.emplace_back(clique[static_cast<std::size_t>(i)],
                             clique[static_cast<std::size_t>(j)], weight * g[i] * g[j]);
  }
  RealSparse blocks(p.H.rows(), p.H.cols());
  blocks.setFromTriplets(entries.begin(), entries.end());
  return blocks;
}

class RealPartial : public ::testing::TestWithParam<int> {};

TEST_P(RealPartial, HasTheMinimiserOfDenseAlgebra) {
  const RealProblem p = randomRealProblem(GetParam(), 5);
  RealPartialCholesky partial;
  partial.build(p.H, nestedDissection(graphOf(p.H)), p.cliques);
  const Eigen::VectorXd linear = partial.reduceLinear(p.c);
  for (const double weight : {0.0, 1.0, 1e3}) {  // one factor after another
    const RealSparse blocks = blocksOf(p, weight);
    ASSERT_TRUE(partial.factor(blocks).ok);
    const Eigen::VectorXd reduced = partial.solve(-linear);
    const Eigen::VectorXd expected = Eigen::MatrixXd(p.H + blocks).ldlt().solve(-p.c);
    EXPECT_LE((partial.extend(reduced, p.c) - expected).norm(), 1e-9 * expected.norm());
  }
}

TEST_P(RealPartial, AppliesTheFormThatIsReduced) {
  const RealProblem p = randomRealProblem(GetParam(), 6);
  RealPartialCholesky partial;
  partial.build(p.H, nestedDissection(graphOf(p.H)), p.cliques);
  ASSERT_TRUE(partial.factor(RealSparse(p.H.rows(), p.H.cols())).ok);
  const Eigen::VectorXd x = partial.solve(p.c);
  // H̃ H̃⁻¹ c is c, where solve() leaves an entry.
  const Eigen::VectorXd back = partial.apply(x);
  for (Eigen::Index i = 0; i < x.size(); ++i)
    EXPECT_NEAR(back[i], x[i] == 0.0 ? 0.0 : p.c[i], 1e-9);
}

TEST_P(RealPartial, LeavesStaticUnknownsOut) {
  const RealProblem p = randomRealProblem(GetParam(), 7);
  RealPartialCholesky partial;
  partial.build(p.H, nestedDissection(graphOf(p.H)), p.cliques);
  const double all = partial.staticCost().multiplyAdds + partial.reducedCost().multiplyAdds;
  EXPECT_GT(all, 0.0);
  const double reduced = partial.reducedCost().multiplyAdds;
  EXPECT_EQ(reduced == 0.0, p.cliques.empty());
  EXPECT_LT(reduced, p.cliques.size() < 2 ? 0.2 * all : 1.0 * all + 1.0);
  const Eigen::VectorXd linear = partial.reduceLinear(p.c);
  for (const std::vector<int>& clique : p.cliques)
    for (const int v : clique) EXPECT_NE(linear[v], 0.0);
  EXPECT_EQ(linear.norm() == 0.0, p.cliques.empty());
}

INSTANTIATE_TEST_SUITE_P(Cliques, RealPartial, ::testing::Values(0, 1, 5, 60, 400));

TEST(RealPartial, FailsWhereAStaticUnknownIsHeldByNothing) {
  RealProblem p = randomRealProblem(3, 8);
  const int lone = static_cast<int>(p.H.rows()) - 20;
  for (int k = 0; k < p.H.outerSize(); ++k)
    for (RealSparse::InnerIterator it(p.H, k); it; ++it)
      if (it.row() == lone || it.col() == lone) it.valueRef() = 0.0;
  RealPartialCholesky partial;
  partial.build(p.H, nestedDissection(graphOf(p.H)), p.cliques);
  const FactorStatus status = partial.factor(RealSparse(p.H.rows(), p.H.cols()));
  EXPECT_FALSE(status.ok);
  EXPECT_EQ(status.badPivot, lone);
}

TEST(RealPartial, LiftsAMatrixThatIsSingularButForRounding) {
  // Constants are in the kernel.
  std::vector<std::pair<int, int>> path;
  for (int i = 1; i < 50; ++i) path.emplace_back(i - 1, i);
  RealProblem p;
  p.H = testing::laplacian<double>(testing::graphFromEdges(50, path), 0.0);
  p.cliques = {{10, 11, 12}};
  RealPartialCholesky partial;
  partial.build(p.H, nestedDissection(graphOf(p.H)), p.cliques);
  const FactorStatus status = partial.factor(RealSparse(p.H.rows(), p.H.cols()));
  EXPECT_TRUE(status.ok);
  EXPECT_GT(status.lift, 0.0);
}

}  // namespace
}  // namespace hgp::linalg
