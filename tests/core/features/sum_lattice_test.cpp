// Numbers of which given sums are integers.  Laws: every integer y gives such numbers, and all of them come from one.
#include "hgp/features/sum_lattice.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>

namespace hgp {
namespace {

double valueOf(const RealSum& sum, const Eigen::VectorXd& x) {
  double value = 0.0;
  for (const auto& [variable, factor] : sum) value += factor * x[variable];
  return value;
}

TEST(SumLattice, IntegersGiveExactlyTheNumbersWithIntegerSums) {
  const std::vector<RealSum> sums{
      {{0, 1.0}, {2, 0.5}}, {{0, 1.0}, {2, -0.5}}, {{1, -1.0}, {2, 1.0}}, {{0, 2.0}, {3, 0.5}},
      {{2, 1.0}},           {{3, 1.0}, {1, 3.0}}};
  SumLattice lattice;
  for (const RealSum& sum : sums) ASSERT_TRUE(lattice.add(sum));
  ASSERT_TRUE(lattice.isComplete());
  ASSERT_EQ(lattice.variables(), (std::vector<int>{0, 1, 2, 3}));
  const Eigen::MatrixXd B = lattice.basis(), inverse = B.inverse();
  for (int i = 0; i < 4; ++i) {
    const Eigen::VectorXd x = inverse * Eigen::VectorXd::Unit(4, i);
    for (const RealSum& sum : sums)
      EXPECT_NEAR(valueOf(sum, x), std::nearbyint(valueOf(sum, x)), 1e-12);
  }
  // Halves of the units in y do not: no coarser lattice would do.
  for (int i = 0; i < 4; ++i) {
    const Eigen::VectorXd x = inverse * (0.5 * Eigen::VectorXd::Unit(4, i));
    bool areIntegers = true;
    for (const RealSum& sum : sums) {
      const double value = valueOf(sum, x);
      areIntegers = areIntegers && std::fabs(value - std::nearbyint(value)) < 1e-12;
    }
    EXPECT_FALSE(areIntegers) << i;
  }
}

/// Sums of three or four of `count` numbers, so many that integers determine all of them.
SumLattice randomLattice(int count, unsigned seed) {
  std::mt19937 random(seed);
  SumLattice lattice;
  for (int n = 0; n < 3 * count || !lattice.isComplete(); ++n) {
    RealSum sum;
    for (int k = 0; k < 3; ++k)
      addTo(sum, {{static_cast<int>(random() % static_cast<unsigned>(count)), 1.0}},
            random() % 2 == 0 ? 0.5 : -1.0);
    EXPECT_TRUE(lattice.add(sum));
  }
  return lattice;
}

TEST(SumLattice, AReducedBasisIsOfTheSameLatticeWithSmallFactors) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    SumLattice lattice = randomLattice(6, seed);
    const Eigen::MatrixXd before = lattice.basis();
    lattice.reduce();
    const Eigen::MatrixXd after = lattice.basis(), change = after * before.inverse();
    EXPECT_NEAR(std::fabs(change.determinant()), 1.0, 1e-6);
    for (Eigen::Index i = 0; i < change.size(); ++i)
      EXPECT_NEAR(change.reshaped()[i], std::nearbyint(change.reshaped()[i]), 1e-6);
    for (Eigen::Index i = 0; i < after.rows(); ++i)
      for (Eigen::Index j = 0; j < after.cols(); ++j) {
        if (j == i) continue;
        EXPECT_LE(std::fabs(after(i, j)), j < i ? 0.0 : 0.5 * std::fabs(after(j, j)));
      }
  }
}

TEST(SumLattice, IntegersThatAreTiedInManyWaysStayExact) {
  // Sums that generate all integers, each the sum or difference of others, many times over.
  for (unsigned seed = 0; seed < 10; ++seed) {
    constexpr int kCount = 60;
    std::mt19937 random(seed);
    std::vector<RealSum> sums;
    for (int i = 0; i < kCount; ++i) sums.push_back({{i, 1.0}});
    for (int n = 0; n < 3 * kCount; ++n) {
      const std::size_t i = random() % kCount, j = random() % kCount;
      if (i != j) addTo(sums[i], RealSum(sums[j]), random() % 2 == 0 ? 1.0 : -1.0);
    }
    SumLattice lattice;
    for (const RealSum& sum : sums) ASSERT_TRUE(lattice.add(sum)) << seed;
    ASSERT_TRUE(lattice.isComplete());
    lattice.reduce();
    EXPECT_EQ(lattice.basis().cwiseAbs(), Eigen::MatrixXd::Identity(kCount, kCount)) << seed;
  }
}

TEST(SumLattice, IsNotCompleteWhereASumAloneTiesTwoNumbers) {
  SumLattice lattice;
  ASSERT_TRUE(lattice.add({{0, 1.0}, {1, 1.0}}));
  EXPECT_FALSE(lattice.isComplete());
  ASSERT_TRUE(lattice.add({{0, 1.0}, {1, -1.0}}));
  EXPECT_TRUE(lattice.isComplete());
}

}  // namespace
}  // namespace hgp
