// Sums over cliques.  Laws: the sparse matrix is the sum of the dense ones, whenever it is summed up again; its pattern
// is that of the cliques.
#include "hgp/optimize/clique_sum.h"

#include <gtest/gtest.h>

#include "support/random.h"

namespace hgp {
namespace {

const std::vector<std::vector<int>> kCliques = {{0, 3, 1}, {4}, {3, 2}, {5, 0, 3}, {1, 1, 2}};
constexpr int kUnknowns = 7;  // the last is in no clique

Eigen::MatrixXd randomMatrix(std::mt19937& random, std::size_t clique) {
  const auto n = static_cast<Eigen::Index>(2 * clique);
  return Eigen::MatrixXd::NullaryExpr(n, n, [&] { return test::randomReal(random); });
}

TEST(CliqueSum, IsTheSumOfTheDenseMatrices) {
  CliqueSum sum(kUnknowns);
  for (const std::vector<int>& clique : kCliques) sum.addClique(clique);
  sum.analyze();
  std::mt19937 random(17);
  for (int round = 0; round < 3; ++round) {
    Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(2 * kUnknowns, 2 * kUnknowns);
    sum.setZero();
    for (const std::vector<int>& clique : kCliques) {
      const Eigen::MatrixXd K = randomMatrix(random, clique.size());
      sum.add(K);
      for (Eigen::Index r = 0; r < K.rows(); ++r)
        for (Eigen::Index c = 0; c < K.cols(); ++c)
          expected(2 * clique[static_cast<std::size_t>(r / 2)] + r % 2,
                   2 * clique[static_cast<std::size_t>(c / 2)] + c % 2) += K(r, c);
    }
    EXPECT_LT((Eigen::MatrixXd(sum.matrix()) - expected).norm(), 1e-14);
  }
}

TEST(CliqueSum, HasAnEntryForEveryCoupleAndTheDiagonal) {
  CliqueSum sum(kUnknowns);
  for (const std::vector<int>& clique : kCliques) sum.addClique(clique);
  const Eigen::MatrixXd couples(sum.couples());
  EXPECT_EQ(couples(0, 5) * couples(5, 0), 1.0);
  EXPECT_EQ(couples(0, 2), 0.0);
  EXPECT_EQ(couples.diagonal().norm(), 0.0);
  sum.analyze();
  const Eigen::Index blocks = kUnknowns + (couples.array() != 0.0).count();
  EXPECT_EQ(sum.matrix().nonZeros(), 4 * blocks);
}

}  // namespace
}  // namespace hgp
