#include "hgp/base/portable_math.h"

#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <numbers>
#include <random>

namespace hgp {
namespace {

using std::numbers::pi;

// The C library's functions in 64 bits of mantissa check those in 53, where it has them; that everywhere else
// the bits are the same is the last test. (Emscripten's long functions are no better than its short ones.)
#if LDBL_MANT_DIG == 64

/// |x − exact| in units of the last place of x.
double ulps(double x, long double exact) {
  if (x == static_cast<double>(exact)) return 0.0;
  const double next = std::nextafter(std::fabs(x), std::numeric_limits<double>::infinity());
  const double unit = next - std::fabs(x);
  return std::fabs(static_cast<double>((x - exact) / static_cast<long double>(unit)));
}

template <class Ours, class Theirs>
double worst(double low, double high, const Ours& ours, const Theirs& theirs, int count = 100000) {
  std::mt19937_64 random(7);
  double most = 0.0;
  for (int i = 0; i < count; ++i) {
    const double share = static_cast<double>(random() >> 11) * 0x1p-53;
    const double x = low + (high - low) * share;
    most = std::max(most, ulps(ours(x), theirs(static_cast<long double>(x))));
  }
  return most;
}

TEST(PortableMath, ExponentialsAndLogarithmsAreWithinTheirUlps) {
  const auto exp = [](long double x) { return std::exp(x); };
  const auto log = [](long double x) { return std::log(x); };
  for (const double reach : {1e-9, 1e-3, 1.0, 30.0, 700.0})
    EXPECT_LT(worst(-reach, reach, portable::exp, exp), 1.0) << reach;
  EXPECT_LT(worst(0.5, 2.0, portable::log, log), 1.0);
  EXPECT_LT(worst(0.999, 1.001, portable::log, log), 1.0);
  EXPECT_LT(worst(1e-300, 1e-290, portable::log, log), 1.0);
  EXPECT_LT(worst(2.0, 1e300, portable::log, log), 1.0);
  EXPECT_LT(worst(-0.5, 3.0, portable::log1p, [](long double x) { return std::log1p(x); }), 3.0);
  EXPECT_LT(worst(-1e-9, 1e-9, portable::log1p, [](long double x) { return std::log1p(x); }), 3.0);
  EXPECT_LT(worst(0.1, 10.0, portable::log2, [](long double x) { return std::log2(x); }), 2.0);
  EXPECT_LT(worst(-30.0, 30.0, portable::cosh, [](long double x) { return std::cosh(x); }), 2.0);
  const auto cube = [](double x) { return portable::pow(x, 3.0); };
  EXPECT_LT(worst(0.5, 2.0, cube, [](long double x) { return x * x * x; }), 2.0 + 3 * 0.7);
  for (double x = -20; x < 20; x += 0.01)
    EXPECT_NEAR(portable::tanh(x), std::tanh(x), 2.3e-16) << x;
}

TEST(PortableMath, SinesAreWithinTheirUlpsBesideEveryQuarterTurn) {
  const auto sin = [](long double x) { return std::sin(x); };
  const auto cos = [](long double x) { return std::cos(x); };
  for (const double reach : {1e-8, 0.7, 7.0, 1e3, 1e6}) {
    EXPECT_LT(worst(-reach, reach, portable::sin, sin), 1.0) << reach;
    EXPECT_LT(worst(-reach, reach, portable::cos, cos), 1.0) << reach;
  }
  for (int n = -40; n <= 40; ++n) {
    const double x = n * pi / 2;
    EXPECT_LT(worst(x - 1e-6, x + 1e-6, portable::sin, sin, 5000), 1.0) << n;
    EXPECT_LT(worst(x - 1e-15, x + 1e-15, portable::cos, cos, 5000), 1.0) << n;
  }
  EXPECT_LT(worst(-1.5, 1.5, portable::tan, [](long double x) { return std::tan(x); }), 3.0);
  EXPECT_NEAR(portable::sin(1e9), std::sin(1e9), 1e-6);
}

TEST(PortableMath, ArcsAreWithinTheirUlpsInEveryQuadrant) {
  double most = 0.0;
  std::mt19937_64 random(3);
  for (int i = 0; i < 400000; ++i) {
    const double scale = std::ldexp(1.0, static_cast<int>(random() % 2000) - 1000);
    const double x = static_cast<double>(static_cast<std::int64_t>(random())) * 0x1p-63 * scale;
    double y = static_cast<double>(static_cast<std::int64_t>(random())) * 0x1p-63 * scale;
    if (i % 3 == 0) y *= 1e-6;
    const long double exact = std::atan2(static_cast<long double>(y), static_cast<long double>(x));
    most = std::max(most, ulps(portable::atan2(y, x), exact));
  }
  EXPECT_LT(most, 2.0);
  EXPECT_LT(worst(-1.0, 1.0, portable::asin, [](long double x) { return std::asin(x); }), 4.0);
  EXPECT_LT(worst(-1.0, 1.0, portable::acos, [](long double x) { return std::acos(x); }), 4.0);
  for (const double x : {0.0, -0.0, 1.0, -1.0})
    for (const double y : {0.0, -0.0, 1.0, -1.0}) {
      EXPECT_EQ(portable::atan2(y, x), std::atan2(y, x)) << y << ' ' << x;
      EXPECT_EQ(std::signbit(portable::atan2(y, x)), std::signbit(std::atan2(y, x)));
    }
}

TEST(PortableMath, LengthsAndQuotientsNeitherOverflowNorVanish) {
  for (const double scale : {1.0, 1e-300, 1e300, 4e-310})
    for (const double y : {0.0, 1e-3, 0.75}) {
      const double x = 1.0 * scale, z = y * scale;
      EXPECT_LT(ulps(portable::hypot(x, z), std::hypot((long double)x, (long double)z)), 2.0);
      EXPECT_LT(ulps(portable::hypot(x, z, x), std::hypot((long double)portable::hypot(x, x), z)),
                4.0);
    }
  EXPECT_EQ(portable::hypot(0.0, -0.0), 0.0);
  using C = std::complex<double>;
  for (const double scale : {1.0, 1e-200, 1e200}) {
    const C b(3 * scale, -4 * scale), a(7, 2), z = portable::divide(a * scale, b);
    EXPECT_NEAR(std::abs(z - a / C(3, -4)), 0.0, 1e-15) << scale;
  }
}

#endif

TEST(PortableMath, UndefinedValuesAreNaNAndLimitsAreThoseOfTheStandard) {
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  for (const double x : {nan, inf, -inf}) {
    EXPECT_TRUE(std::isnan(portable::sin(x)) && std::isnan(portable::cos(x)));
    EXPECT_TRUE(std::isnan(portable::asin(x)));
  }
  EXPECT_TRUE(std::isnan(portable::log(-1.0)) && std::isnan(portable::log(nan)));
  EXPECT_TRUE(std::isnan(portable::atan2(nan, 1.0)) && std::isnan(portable::acos(1.0000001)));
  for (const double y : {inf, -inf, 2.0, -0.0})
    for (const double x : {inf, -inf, 3.0})
      EXPECT_EQ(portable::atan2(y, x), std::atan2(y, x)) << y << " " << x;
  EXPECT_EQ(portable::log(0.0), -inf);
  EXPECT_EQ(portable::log(inf), inf);
  EXPECT_EQ(portable::exp(-inf), 0.0);
  EXPECT_EQ(portable::exp(1000.0), inf);
  EXPECT_TRUE(std::isnan(portable::exp(nan)) && std::isnan(portable::hypot(nan, 1.0)));
  EXPECT_EQ(portable::exp(0.0), 1.0);
  EXPECT_EQ(portable::log(1.0), 0.0);
  EXPECT_EQ(portable::log2(0x1p-1000), -1000.0);
  EXPECT_EQ(portable::hypot(inf, 1.0), inf);
  EXPECT_EQ(portable::sin(0.0), 0.0);
  EXPECT_EQ(portable::pow(0.0, 2.0), 0.0);
}

// The promise itself: these very bits on every processor, system and compiler.
TEST(PortableMath, TheBitsAreTheSameEverywhere) {
  std::mt19937_64 random(11);
  std::uint64_t sum = 0;
  const auto add = [&](double x) {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    sum = (sum ^ bits) * 0x9e3779b97f4a7c15u;
  };
  for (int i = 0; i < 20000; ++i) {
    const double x = 40.0 * (static_cast<double>(random() >> 11) * 0x1p-53 - 0.5);
    const double y = 40.0 * (static_cast<double>(random() >> 11) * 0x1p-53 - 0.5);
    for (const double value :
         {portable::sin(x), portable::cos(x), portable::tan(x), portable::exp(x),
          portable::log(std::fabs(x)), portable::atan2(y, x), portable::hypot(x, y),
          portable::pow(std::fabs(x), y), portable::tanh(x), portable::acos(x / 20.0)})
      add(value);
  }
  EXPECT_EQ(sum, 13264580594892453240u);
}

}  // namespace
}  // namespace hgp
