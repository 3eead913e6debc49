#include "hgp/socp/second_order_cone.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/random.h"

namespace hgp::socp {
namespace {

/// Inside the cone; `margin` down to 1e-9 of its size puts it next to the boundary.
Vector3 insidePoint(std::mt19937& random, double margin) {
  const double x = test::randomReal(random), y = test::randomReal(random);
  const double scale = std::pow(10.0, 3.0 * test::randomReal(random));
  return scale * Vector3(std::hypot(x, y) + margin, x, y);
}

TEST(SecondOrderCone, ProductAndDivisionAreInverse) {
  std::mt19937 random(73);
  for (int round = 0; round < 500; ++round) {
    const Vector3 lambda = insidePoint(random, 0.1);
    const Vector3 b(test::randomReal(random), test::randomReal(random), test::randomReal(random));
    EXPECT_LT((product(lambda, divide(lambda, b)) - b).norm(), 1e-12);
    EXPECT_LT((product(lambda, b) - product(b, lambda)).norm(), 1e-15 * lambda.norm());
  }
}

TEST(SecondOrderCone, DeterminantAndDepthVanishOnTheBoundaryAlone) {
  EXPECT_EQ(determinant({5, 3, 4}), 0.0);
  EXPECT_EQ(depth({5, 3, 4}), 0.0);
  EXPECT_GT(depth({5.001, 3, 4}), 0.0);
  EXPECT_LT(depth({4.999, 3, 4}), 0.0);
  // Without cancellation: s₀ = 1 + 1e-12 beside radius 1.
  const double e = std::ldexp(1.0, -40);
  EXPECT_NEAR(determinant({1 + e, 1, 0}) / (2 * e), 1.0, 1e-9);
}

TEST(NesterovTodd, ScalesBothPointsToTheSame) {
  std::mt19937 random(79);
  for (double margin : {1.0, 1e-3, 1e-6}) {
    for (int round = 0; round < 200; ++round) {
      const Vector3 s = insidePoint(random, margin), y = insidePoint(random, margin);
      const Scaling scaling = ntScaling(s, y);
      const double size = scaling.lambda.norm();
      const double tolerance = 1e-12 / margin;
      EXPECT_LT((scaling.W * y - scaling.lambda).norm(), tolerance * size);
      EXPECT_LT((scaling.inverse * s - scaling.lambda).norm(), tolerance * size);
      EXPECT_LT((scaling.W - scaling.W.transpose()).norm(), 1e-13 * scaling.W.norm());
      EXPECT_LT((scaling.W * scaling.inverse - Matrix3::Identity()).norm(),
                1e-13 * scaling.W.norm() * scaling.inverse.norm());
      EXPECT_GT(depth(scaling.lambda), 0.0);
      // λᵀλ = sᵀy: the gap is kept.
      EXPECT_NEAR(scaling.lambda.squaredNorm() / s.dot(y), 1.0, 1e-9 / margin * 1e-3 + 1e-9);
    }
  }
}

TEST(NesterovTodd, KeepsTheCone) {
  std::mt19937 random(83);
  for (int round = 0; round < 200; ++round) {
    const Scaling scaling = ntScaling(insidePoint(random, 0.1), insidePoint(random, 0.1));
    EXPECT_GT(depth(scaling.W * insidePoint(random, 0.01)), 0.0);
    EXPECT_GT(depth(scaling.inverse * insidePoint(random, 0.01)), 0.0);
  }
}

TEST(StepLength, EndsAtTheBoundaryOrAtOne) {
  std::mt19937 random(89);
  int cut = 0, full = 0;
  for (int round = 0; round < 2000; ++round) {
    const Vector3 s = insidePoint(random, round % 2 ? 0.3 : 1e-3);
    Vector3 ds(test::randomReal(random), test::randomReal(random), test::randomReal(random));
    ds *= 2.0 * s.norm();
    const double alpha = stepLength(s, ds);
    ASSERT_GE(alpha, 0.0);
    ASSERT_LE(alpha, 1.0);
    const double tolerance = 1e-9 * s.norm();
    for (double share : {0.25, 0.5, 0.75, 1.0})
      EXPECT_GT(depth(s + share * alpha * ds), -tolerance);
    if (alpha < 1.0) {
      EXPECT_LT(std::abs(depth(s + alpha * ds)), tolerance);
      ++cut;
    } else {
      ++full;
    }
  }
  EXPECT_GT(cut, 200);
  EXPECT_GT(full, 200);
}

TEST(StepLength, IsOneForDirectionsInsideTheCone) {
  EXPECT_EQ(stepLength({1, 0, 0}, {1, 0, 0}), 1.0);
  EXPECT_EQ(stepLength({1, 0, 0}, {1, 1, 0}), 1.0);
  EXPECT_EQ(stepLength({1, 0, 0}, {0, 0, 0}), 1.0);
  EXPECT_NEAR(stepLength({1, 0, 0}, {-2, 0, 0}), 0.5, 1e-15);
  EXPECT_NEAR(stepLength({1, 0, 0}, {0, 2, 0}), 0.5, 1e-15);
}

}  // namespace
}  // namespace hgp::socp
