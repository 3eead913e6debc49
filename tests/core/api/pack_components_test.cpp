// Components beside each other: apart, near the origin, and shifted by what costs no digit.
#include "hgp/api/stored/pack_components.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace hgp::api {
namespace {

UvBox boxAt(double u, double v, double width, double height) {
  UvBox box;
  box.add({u, v});
  box.add({u + width, v + height});
  return box;
}

/// Sizes over six powers of ten, places anywhere.
std::vector<UvBox> randomBoxes(int count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<UvBox> boxes;
  for (int i = 0; i < count; ++i) {
    const double size = std::pow(10.0, 6 * unit(random) - 3);
    boxes.push_back(boxAt(100 * unit(random) - 50, 100 * unit(random) - 50, size * unit(random),
                          size * unit(random)));
  }
  return boxes;
}

bool isMultipleOfPower(double shift, double extent) {
  return std::fmod(shift, std::ldexp(1.0, std::ilogb(extent) - 4)) == 0;
}

TEST(PackComponents, NoTwoOverlapAndShiftsAreMultiplesOfAPowerOfTwo) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const std::vector<UvBox> boxes = randomBoxes(60, seed);
    const std::vector<Vec2> shifts = packBoxes(boxes);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_TRUE(isMultipleOfPower(shifts[i][k], boxes[i].extent())) << shifts[i][k];
        EXPECT_GE(boxes[i].low[k] + shifts[i][k], 0.0);
      }
      for (std::size_t j = 0; j < i; ++j) {
        bool isApart = false;
        for (std::size_t k = 0; k < 2; ++k) {
          const double a = boxes[i].low[k] + shifts[i][k], b = boxes[j].low[k] + shifts[j][k];
          isApart = isApart || a > b + boxes[j].size(k) || b > a + boxes[i].size(k);
        }
        EXPECT_TRUE(isApart) << "seed " << seed << ": " << i << " and " << j;
      }
    }
  }
}

TEST(PackComponents, ABoxIsNotFartherThanTheSquareOfThoseBeforeIt) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const std::vector<UvBox> boxes = randomBoxes(400, seed);
    const std::vector<Vec2> shifts = packBoxes(boxes);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      double area = 0;
      for (const UvBox& other : boxes) {
        if (other.extent() <= boxes[i].extent()) area += other.extent() * other.extent();
      }
      for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_LE(boxes[i].high[k] + shifts[i][k], 4 * std::sqrt(area)) << "seed " << seed;
      }
    }
  }
}

TEST(PackComponents, ManyEqualOnesFillASquareInsteadOfARow) {
  const std::vector<UvBox> boxes(10000, boxAt(-0.5, -0.5, 1, 1));
  double farthest = 0;
  for (const Vec2& shift : packBoxes(boxes)) farthest = std::max({farthest, shift[0], shift[1]});
  EXPECT_LT(farthest, 120.0);
}

TEST(PackComponents, ASingleComponentStaysAndAUnitIsKept) {
  EXPECT_EQ(packBoxes({boxAt(7, -3, 1, 2)})[0], (Vec2{0, 0}));
  UvBox nothing;
  EXPECT_EQ(packBoxes({nothing, boxAt(7, -3, 1, 2), nothing})[1], (Vec2{0, 0}));
  for (const Vec2& shift : packBoxes(randomBoxes(30, 5), 1.0)) {
    EXPECT_EQ(shift[0], std::round(shift[0]));
    EXPECT_EQ(shift[1], std::round(shift[1]));
  }
  const Vec2 shift = centringShift(boxAt(1000.3, -2000.7, 1, 1));
  EXPECT_NEAR(shift[0], -1000.8, 0.05);
  EXPECT_TRUE(isMultipleOfPower(shift[1], 1.0));
}

}  // namespace
}  // namespace hgp::api
