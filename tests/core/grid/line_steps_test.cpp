#include "hgp/grid/line_steps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace hgp {
namespace {

/// Demands that the integers `kept` fulfil, some of them with equality.
std::vector<LineDemand> demandsAround(const Eigen::VectorXd& kept, int count,
                                      std::mt19937& random) {
  std::vector<LineDemand> demands;
  for (int n = 0; n < count; ++n) {
    LineDemand demand;
    for (int k = 0; k < 4; ++k) {
      const int j = static_cast<int>(random() % static_cast<unsigned>(kept.size()));
      demand.terms.push_back({j, random() % 2 == 0 ? 1.0 : -1.0});
    }
    demand.least = demand.valueAt(kept) - static_cast<double>(random() % 3);
    demands.push_back(std::move(demand));
  }
  return demands;
}

double missingIn(const std::vector<LineDemand>& demands, const Eigen::VectorXd& y) {
  double sum = 0.0;
  for (const LineDemand& demand : demands) sum += demand.missingAt(y);
  return sum;
}

TEST(LineDemand, WhatIsMissingIsMeasuredUpToRounding) {
  const LineDemand demand{{{0, 2.0}, {2, -1.0}}, 3.0};
  EXPECT_EQ(demand.valueAt(Eigen::Vector3d(1.5, 7.0, 0.5)), 2.5);
  EXPECT_NEAR(demand.missingAt(Eigen::Vector3d(1.5, 7.0, 0.5)), 0.5, 2.0 * kLineZero);
  EXPECT_EQ(demand.missingAt(Eigen::Vector3d(1.5, 7.0, 0.0)), 0.0);
  EXPECT_EQ(demand.missingAt(Eigen::Vector3d(1.5, 7.0, 0.5 * kLineZero)), 0.0);
  EXPECT_EQ(demand.missingAt(Eigen::Vector3d(9.0, 7.0, 0.0)), 0.0);
}

TEST(LineSteps, RoundingsThatBreakDemandsAreMendedAndThenLowered) {
  std::mt19937 random(20);
  for (int trial = 0; trial < 40; ++trial) {
    const Eigen::Index size = 6 + trial % 10;
    Eigen::VectorXd kept(size), y0(size), start(size);
    for (Eigen::Index j = 0; j < size; ++j) {
      kept[j] = static_cast<double>(random() % 9) - 4.0;
      y0[j] = kept[j] + 1e-3 * static_cast<double>(random() % 4000) - 2.0;
      start[j] = std::nearbyint(y0[j]);
    }
    const std::vector<LineDemand> demands = demandsAround(kept, 2 * static_cast<int>(size), random);
    const LineSteps steps(Eigen::MatrixXd::Identity(size, size), demands);
    double work = 1e8;
    const Eigen::VectorXd y = steps.mended(y0, start, work);
    EXPECT_EQ(missingIn(demands, y), 0.0) << trial;
    EXPECT_LT(work, 1e8);
    const auto form = [&](const Eigen::VectorXd& at) { return (at - y0).squaredNorm(); };
    for (Eigen::Index j = 0; j < size; ++j)
      for (const double unit : {1.0, -1.0}) {
        Eigen::VectorXd other = y;
        EXPECT_EQ(y[j], std::nearbyint(y[j]));
        other[j] += unit;
        EXPECT_TRUE(form(other) >= form(y) - 1e-9 || missingIn(demands, other) > 0.0) << trial;
      }
  }
}

TEST(LineSteps, StepsAreThoseOfAReducedBasis) {
  // Both numbers move together at no cost, and apart at a high one: steps along (1, 1) reach the minimum.
  Eigen::MatrixXd S(2, 2);
  S << 1.0, -0.999, -0.999, 1.0;
  const LineSteps steps(S, {});
  double work = 1e6;
  const Eigen::Vector2d y =
      steps.mended(Eigen::Vector2d(7.0, 7.0), Eigen::Vector2d(0.0, 0.0), work);
  EXPECT_EQ(y, Eigen::Vector2d(7.0, 7.0));
}

TEST(LineSteps, WhatCannotBeFulfilledDoesNotKeepTheRestFromIt) {
  // y₀ ≥ 1 and y₀ ≤ −1 exclude each other; y₁ ≥ 2 does not.
  const std::vector<LineDemand> demands = {
      {{{0, 1.0}}, 1.0}, {{{0, -1.0}}, 1.0}, {{{1, 1.0}}, 2.0}};
  const LineSteps steps(Eigen::MatrixXd::Identity(2, 2), demands);
  double work = 1e7;
  const Eigen::VectorXd y =
      steps.mended(Eigen::Vector2d(0.2, 0.3), Eigen::Vector2d(0.0, 0.0), work);
  EXPECT_EQ(demands[2].missingAt(y), 0.0);
  EXPECT_GT(work, 0.0);
}

TEST(LineSteps, EndWhereTheWorkIsDone) {
  std::mt19937 random(3);
  const Eigen::VectorXd kept = Eigen::VectorXd::Constant(8, 5.0), zero = Eigen::VectorXd::Zero(8);
  const LineSteps steps(Eigen::MatrixXd::Identity(8, 8), demandsAround(kept, 16, random));
  double none = 0.0;
  EXPECT_EQ(steps.mended(zero, zero, none), zero);
}

}  // namespace
}  // namespace hgp
