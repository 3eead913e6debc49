// Integers near given numbers that keep inequalities.  Laws: without demands they are the nearest; with them, none is broken
// where there is room, and order is kept.
#include "hgp/grid/line_choice.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hgp {
namespace {

/// Neighbours are at least one apart, in order.
std::vector<LineDemand> inOrder(int n) {
  std::vector<LineDemand> demands;
  for (int i = 1; i < n; ++i) demands.push_back({{{i - 1, -1.0}, {i, 1.0}}, 1.0});
  return demands;
}

TEST(LineChoice, WithoutDemandsTheNearestIntegersAreTaken) {
  const Eigen::Vector3d y0(0.4, -2.7, 9.1);
  const LineChoice choice(Eigen::MatrixXd::Identity(3, 3), {});
  double work = 1e6;
  EXPECT_EQ(choice.near(y0, work).value(), Eigen::Vector3d(0, -3, 9));
  EXPECT_LT(work, 1e6);
}

TEST(LineChoice, CrowdedLinesKeepTheirOrder) {
  for (const int n : {2, 5, 17, 40}) {
    Eigen::VectorXd y0(n);
    for (int i = 0; i < n; ++i) y0[i] = 0.3 * i + 0.05 * std::sin(7.0 * i);
    // Neighbours move together.
    Eigen::MatrixXd C(n, n);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) C(i, j) = std::pow(0.8, std::abs(i - j));
    const LineChoice choice(C, inOrder(n));
    double work = 1e7;
    const Eigen::VectorXd y = choice.near(y0, work).value();
    EXPECT_EQ(choice.broken(y), 0) << n;
    for (int i = 0; i < n; ++i) EXPECT_EQ(y[i], std::nearbyint(y[i])) << n;
    // Spread on both sides: the middle one stays.
    EXPECT_LE(std::fabs(y[n / 2] - y0[n / 2]), 2.0) << n;
    // The same with just that much work; with less, nothing.
    const double spent = 1e7 - work;
    double enough = spent + 1.0, less = spent;
    EXPECT_EQ(choice.near(y0, enough).value(), y) << n;
    EXPECT_FALSE(choice.near(y0, less)) << n;
  }
}

TEST(LineChoice, AFixedSumIsPushedThrough) {
  // Three lines between two walls that have just room for them; the walls hardly move.
  Eigen::VectorXd y0(5), stiff(5);
  y0 << 0.1, 0.4, 0.5, 0.6, 4.2;
  stiff << 1e-3, 1.0, 1.0, 1.0, 1e-3;
  const LineChoice choice(stiff.asDiagonal().toDenseMatrix(), inOrder(5));
  double work = 1e6;
  const Eigen::VectorXd y = choice.near(y0, work).value();
  EXPECT_EQ(y, (Eigen::VectorXd(5) << 0, 1, 2, 3, 4).finished());
}

TEST(LineChoice, OnlyWhatAMultipleOfTheGivenPointFulfilsIsAlwaysPossible) {
  // Five lines in order, and a demand that the first two be in reverse order.
  Eigen::VectorXd y0(5);
  y0 << 0.0, 0.1, 0.7, 0.9, 1.6;
  std::vector<LineDemand> demands = inOrder(5);
  demands.push_back({{{0, 1.0}, {1, -1.0}}, 0.0});
  const LineChoice choice(Eigen::MatrixXd::Identity(5, 5), demands);
  double work = 1e6;
  EXPECT_GT(choice.broken(choice.near(y0, work).value()), 0);
  const LineChoice positive = choice.positiveAt(y0);
  const Eigen::VectorXd y = positive.near(y0, work).value();
  EXPECT_EQ(positive.broken(y), 0);
  for (int i = 1; i < 5; ++i) EXPECT_GE(y[i] - y[i - 1], 1.0);
  EXPECT_EQ(choice.broken(y), 1) << "the reverse order, and no other demand";
  // What does not hold at the given point is left out on its account alone.
  EXPECT_EQ(choice.positiveAt(-y0).broken(y), 1);
}

}  // namespace
}  // namespace hgp
