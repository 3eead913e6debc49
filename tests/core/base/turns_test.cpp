#include "hgp/base/turns.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hgp {
namespace {

TEST(Turns, ReducedTurnsAreResidues) {
  for (int q = 1; q <= 64; ++q)
    for (long long r = -3LL * q - 1; r <= 3LL * q + 1; ++r) {
      const int n = reduceTurn(r, q);
      EXPECT_TRUE(n >= 0 && n < q && (r - n) % q == 0);
    }
  EXPECT_EQ(reduceTurn(-(1LL << 62), 7), static_cast<int>(((-(1LL << 62)) % 7 + 7) % 7));
}

TEST(Turns, RotationsAreOnTheCircleWithinOneRounding) {
  for (int q = 1; q <= 64; ++q)
    for (int r = 0; r < q; ++r) {
      const Complex z = rotation(r, q);
      const long double angle = 2.0L * 3.14159265358979323846264338327950288L * r / q;
      EXPECT_NEAR(z.real(), static_cast<double>(cosl(angle)), 1.2e-16);
      EXPECT_NEAR(z.imag(), static_cast<double>(sinl(angle)), 1.2e-16);
    }
}

TEST(Turns, QuarterTurnsAreExact) {
  for (int n : {1, 2, 3, 16}) {
    EXPECT_EQ(rotation(0, 4 * n), Complex(1, 0));
    EXPECT_EQ(rotation(n, 4 * n), Complex(0, 1));
    EXPECT_EQ(rotation(2 * n, 4 * n), Complex(-1, 0));
    EXPECT_EQ(rotation(3 * n, 4 * n), Complex(0, -1));
    EXPECT_EQ(rotation(n, 2 * n), Complex(-1, 0));
  }
}

TEST(Turns, OppositeRotationsAreExactConjugates) {
  for (int q = 1; q <= 64; ++q)
    for (int r = -q; r <= 2 * q; ++r) {
      EXPECT_EQ(rotation(-r, q), std::conj(rotation(r, q))) << r << "/" << q;
      EXPECT_EQ(rotation(r + q, q), rotation(r, q));
    }
}

TEST(Turns, EighthTurnsAreSymmetric) {
  const Complex z = rotation(1, 8);
  EXPECT_EQ(z.real(), z.imag());
  EXPECT_EQ(rotation(3, 8), Complex(-z.real(), z.imag()));
}

TEST(Turns, PrincipalAnglesLieInTheHalfOpenInterval) {
  for (int n = -7; n <= 7; ++n) {
    EXPECT_NEAR(principalAngle(0.5 + 2 * kPi * n), 0.5, 1e-14);
    const double a = principalAngle(kPi + 2 * kPi * n);
    EXPECT_TRUE(a > -kPi && a <= kPi);
  }
  EXPECT_EQ(principalAngle(-kPi), kPi);
}

TEST(Turns, PrincipalAngleIsTheRemainderToTheLastBit) {
  for (double angle = -11.0; angle < 11.0; angle += 0.00037) {
    const double exact = std::remainder(angle, 2 * kPi);
    EXPECT_EQ(principalAngle(angle), exact <= -kPi ? exact + 2 * kPi : exact) << angle;
  }
}

}  // namespace
}  // namespace hgp
