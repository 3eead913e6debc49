#include "hgp/verify/orientation.h"

#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>
#include <cstdint>
#include <random>

namespace hgp {
namespace {

__extension__ typedef __int128 Exact;

struct IntegerPoint {
  std::int64_t x, y;
};

int exactSign(const IntegerPoint& a, const IntegerPoint& b, const IntegerPoint& c) {
  const Exact det =
      static_cast<Exact>(b.x - a.x) * (c.y - a.y) - static_cast<Exact>(b.y - a.y) * (c.x - a.x);
  return det > 0 ? 1 : det < 0 ? -1 : 0;
}

Vec2 scaled(const IntegerPoint& p, int ex, int ey) {
  return {std::ldexp(static_cast<double>(p.x), ex), std::ldexp(static_cast<double>(p.y), ey)};
}

/// A random integer of at most `bits` bits, either sign.
std::int64_t randomInteger(std::mt19937_64& random, int bits) {
  const auto n = static_cast<std::int64_t>(random() >> (64 - bits));
  return random() & 1 ? -n : n;
}

struct Triangle {
  IntegerPoint a, b, c;
};

/// c lies within a few units of the line through a and b.
Triangle nearlyFlat(std::mt19937_64& random, int bits) {
  Triangle t{{randomInteger(random, bits), randomInteger(random, bits)},
             {randomInteger(random, bits), randomInteger(random, bits)},
             {0, 0}};
  const double s = static_cast<double>(random() >> 11) / 9007199254740992.0;
  const auto between = [&](std::int64_t p, std::int64_t q) {
    return static_cast<std::int64_t>(
        std::llround((1 - s) * static_cast<double>(p) + s * static_cast<double>(q)));
  };
  t.c = {between(t.a.x, t.b.x) + static_cast<int>(random() % 3) - 1,
         between(t.a.y, t.b.y) + static_cast<int>(random() % 3) - 1};
  return t;
}

TEST(Orientation, AgreesWithExactIntegersOnNearlyFlatTriangles) {
  std::mt19937_64 random(7);
  int seen[3] = {};
  for (int round = 0; round < 30000; ++round) {
    const int bits = round % 5 == 0 ? 4 : 20 + round % 32;
    const Triangle t = nearlyFlat(random, bits);
    const int expected = exactSign(t.a, t.b, t.c);
    ++seen[expected + 1];
    // Exponents from denormals to the top of the range, different in u and v.
    const int low = -1074, high = 1023 - bits - 1;
    const int ex = low + static_cast<int>(random() % static_cast<unsigned>(high - low));
    const int ey = low + static_cast<int>(random() % static_cast<unsigned>(high - low));
    for (const auto& [x, y] : {std::pair{0, 0}, {ex, ey}, {low, low}, {high, high}, {low, high}}) {
      const Vec2 a = scaled(t.a, x, y), b = scaled(t.b, x, y), c = scaled(t.c, x, y);
      ASSERT_EQ(orientationSign(a, b, c), expected) << round << " " << x << " " << y;
      ASSERT_EQ(exactOrientationSign(a, b, c), expected) << round << " " << x << " " << y;
    }
  }
  for (int count : seen) EXPECT_GT(count, 100);
}

TEST(Orientation, AgreesWithExactIntegersWhereDifferencesAreRounded) {
  // 53 significant bits at different heights: b − a is no double any more.
  std::mt19937_64 random(13);
  const auto anyPoint = [&] {
    const auto coordinate = [&] { return randomInteger(random, 53) * (1LL << (random() % 8)); };
    return IntegerPoint{coordinate(), coordinate()};
  };
  int disagreements = 0;
  for (int round = 0; round < 200000; ++round) {
    Triangle t{anyPoint(), anyPoint(), {0, 0}};
    const double s = static_cast<double>(random() >> 11) / 9007199254740992.0;
    const auto nearest = [&](std::int64_t p, std::int64_t q) {  // a double again
      return static_cast<std::int64_t>(static_cast<double>(p) +
                                       s * (static_cast<double>(q) - static_cast<double>(p)));
    };
    t.c = {nearest(t.a.x, t.b.x), nearest(t.a.y, t.b.y)};
    const Vec2 a = scaled(t.a, 0, 0), b = scaled(t.b, 0, 0), c = scaled(t.c, 0, 0);
    const int expected = exactSign(t.a, t.b, t.c);
    ASSERT_EQ(orientationSign(a, b, c), expected);
    const double plain = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    disagreements += (plain > 0) - (plain < 0) != expected;
  }
  EXPECT_GT(disagreements, 100) << "the cases are hard enough to fool plain arithmetic";
}

TEST(Orientation, AreasAreExactWhateverCancels) {
  std::mt19937_64 random(17);
  for (int round = 0; round < 30000; ++round) {
    const Triangle t = nearlyFlat(random, 20 + round % 32);
    const Exact twice = static_cast<Exact>(t.b.x - t.a.x) * (t.c.y - t.a.y) -
                        static_cast<Exact>(t.b.y - t.a.y) * (t.c.x - t.a.x);
    const auto expected = static_cast<double>(twice);
    for (const int e : {0, -300, 200}) {
      const double area = exactTwiceArea(scaled(t.a, e, e), scaled(t.b, e, e), scaled(t.c, e, e));
      ASSERT_LE(std::fabs(std::ldexp(area, -2 * e) - expected), 2e-16 * std::fabs(expected));
    }
  }
  EXPECT_EQ(exactTwiceArea({0, 0}, {1e200, 0}, {0, 1e200}), HUGE_VAL);
  EXPECT_EQ(exactTwiceArea({0, 0}, {1e-200, 0}, {0, 1e-200}), 0.0);
}

TEST(Orientation, IsAntisymmetricAndCyclicForAnyDoubles) {
  std::mt19937_64 random(11);
  const auto anyDouble = [&] {
    double x = 0;
    do {
      const std::uint64_t bits = random();
      static_assert(sizeof x == sizeof bits);
      __builtin_memcpy(&x, &bits, sizeof x);
    } while (!std::isfinite(x));
    return x;
  };
  for (int round = 0; round < 20000; ++round) {
    const Vec2 a{anyDouble(), anyDouble()}, b{anyDouble(), anyDouble()},
        c{anyDouble(), anyDouble()};
    const int sign = orientationSign(a, b, c);
    ASSERT_EQ(sign, exactOrientationSign(a, b, c));
    ASSERT_EQ(sign, orientationSign(b, c, a));
    ASSERT_EQ(sign, -orientationSign(b, a, c));
    ASSERT_EQ(0, orientationSign(a, b, b));
  }
}

TEST(Orientation, DetectsTheSmallestTriangleThatDoublesCanHold) {
  const double d = DBL_TRUE_MIN;
  EXPECT_EQ(orientationSign({0, 0}, {d, 0}, {0, d}), 1);
  EXPECT_EQ(orientationSign({0, 0}, {0, d}, {d, 0}), -1);
  EXPECT_EQ(orientationSign({0, 0}, {d, d}, {2 * d, 2 * d}), 0);
  EXPECT_EQ(orientationSign({1, 1}, {1, 1 + DBL_EPSILON}, {1 - DBL_EPSILON / 2, 1}), 1);
}

TEST(Orientation, HandlesTheLargestDoubles) {
  const double m = DBL_MAX;
  EXPECT_EQ(orientationSign({-m, -m}, {m, -m}, {m, m}), 1);
  EXPECT_EQ(orientationSign({-m, -m}, {m, m}, {m, -m}), -1);
  EXPECT_EQ(orientationSign({-m, -m}, {0, 0}, {m, m}), 0);
  EXPECT_EQ(orientationSign({-m, -m}, {DBL_TRUE_MIN, 0}, {m, m}), 1);
  EXPECT_EQ(orientationSign({-m, -m}, {0, DBL_TRUE_MIN}, {m, m}), -1);
}

}  // namespace
}  // namespace hgp
