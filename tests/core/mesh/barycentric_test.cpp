// Weights of points near a triangle.  Laws: they give the point back and do not depend on the unit of length.
#include "hgp/mesh/barycentric.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hgp {
namespace {

TEST(WeightsIn, GiveThePointBackInEveryUnitOfLength) {
  for (const int exponent : {0, -332, -299, 60}) {
    const double unit = std::scalbn(1.0, exponent);
    const std::array<Vec3, 3> triangle{scaled({0.1, 0, 0}, unit), scaled({1, 0.2, 0.4}, unit),
                                       scaled({0.3, 0.9, -0.5}, unit)};
    const std::array<double, 3> given{0.5, 0.375, 0.125};
    Vec3 p{};
    for (std::size_t k = 0; k < 3; ++k) p = add(p, scaled(triangle[k], given[k]));
    const std::array<double, 3> weight = weightsIn(triangle, p);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(weight[k], given[k], 1e-14) << exponent;
  }
}

TEST(WeightsIn, OfATriangleWithoutAreaAreThoseOfTheNearestCorner) {
  const std::array<Vec3, 3> line{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{2, 0, 0}};
  EXPECT_EQ(weightsIn(line, {1.2, 1, 0}), (std::array<double, 3>{0, 1, 0}));
  EXPECT_EQ(weightsIn({}, {1, 1, 0}), (std::array<double, 3>{1, 0, 0}));
}

}  // namespace
}  // namespace hgp
