#include "hgp/base/float32.h"

#include <gtest/gtest.h>

#include <array>
#include <cfloat>
#include <cmath>
#include <random>
#include <vector>

namespace hgp {
namespace {

TEST(Float32, RoundsPairsThatACompilerMightLeaveUnrounded) {
  for (std::size_t n = 1; n < 9; ++n) {
    std::vector<std::array<double, 2>> points(n, {0.1, 0.2});
    for (auto& p : points) p = {roundToFloat(p[0]), roundToFloat(p[1])};
    for (const auto& p : points) {
      EXPECT_EQ(p[0], 0x1.99999ap-4);
      EXPECT_EQ(p[1], 0x1.99999ap-3);
    }
  }
}

TEST(Float32, IsTheNearestFloat) {
  std::mt19937 random(2);
  for (int n = 0; n < 10000; ++n) {
    const double x =
        std::ldexp(static_cast<double>(random()), static_cast<int>(random() % 250) - 160) *
        (1 + static_cast<double>(random()) * 0x1p-60);
    const double y = roundToFloat(x);
    const volatile float stored = static_cast<float>(y);
    EXPECT_EQ(static_cast<double>(stored), y);
    const auto f = static_cast<float>(y);
    EXPECT_LE(std::fabs(x - y), std::fabs(x - std::nextafterf(f, -FLT_MAX)));
    EXPECT_LE(std::fabs(x - y), std::fabs(x - std::nextafterf(f, FLT_MAX)));
    EXPECT_EQ(roundToFloat(-x), -y);
    EXPECT_EQ(roundToFloat(y), y);
  }
}

TEST(Float32, BeyondTheRangeIsInfinite) {
  EXPECT_EQ(roundToFloat(FLT_MAX), FLT_MAX);
  EXPECT_EQ(roundToFloat(std::nextafter(0x1.ffffffp127, 0)), FLT_MAX);
  EXPECT_EQ(roundToFloat(0x1.ffffffp127), HUGE_VAL);
  EXPECT_EQ(roundToFloat(-1e300), -HUGE_VAL);
  EXPECT_EQ(roundToFloat(HUGE_VAL), HUGE_VAL);
  EXPECT_TRUE(std::isnan(roundToFloat(std::nan(""))));
  EXPECT_EQ(roundToFloat(1e-60), 0.0);
}

}  // namespace
}  // namespace hgp
