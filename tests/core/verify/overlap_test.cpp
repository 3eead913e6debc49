#include "hgp/verify/overlap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace hgp {
namespace {

/// n × n squares of two triangles each.
UvMap sheet(int n) {
  UvMap map;
  const auto id = [n](int i, int j) { return i * (n + 1) + j; };
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) map.uv.push_back({i + 0.3 * std::sin(j), j + 0.2 * std::cos(i)});
  }
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      map.cornerUv.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      map.cornerUv.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  }
  return map;
}

/// The sheet once more, moved to the right.
UvMap twoSheets(int n, double shift) {
  UvMap map = sheet(n);
  const UvMap one = map;
  const int count = static_cast<int>(one.uv.size());
  for (const Vec2& p : one.uv) map.uv.push_back({p[0] + shift, p[1]});
  for (const auto& c : one.cornerUv) {
    map.cornerUv.push_back({c[0] + count, c[1] + count, c[2] + count});
  }
  return map;
}

TEST(Overlap, NeighboursShareNothing) {
  for (int n : {1, 3, 10, 100}) {
    const OverlapFacts facts = measureOverlap(sheet(n));
    EXPECT_EQ(facts.layers, 1) << n;
    EXPECT_EQ(facts.share, 0.0) << n;
  }
}

TEST(Overlap, IsTheShareOfWhatIsCovered) {
  EXPECT_EQ(measureOverlap(twoSheets(8, 100)).layers, 1);
  const OverlapFacts half = measureOverlap(twoSheets(8, 4));
  EXPECT_EQ(half.layers, 2);
  EXPECT_NEAR(half.share, 4.0 / 12.0, 0.03);
  const OverlapFacts whole = measureOverlap(twoSheets(8, 0));
  EXPECT_EQ(whole.share, 1.0);
}

TEST(Overlap, CellsCountByTheirCentres) {
  // A square of 4 × 4 cells and a strip of its full height at the left or right border.
  const auto share = [](double from, double to) {
    UvMap map;
    for (const auto& [low, high] : {std::pair{0.0, 4.0}, {from, to}}) {
      const int first = static_cast<int>(map.uv.size());
      map.uv.insert(map.uv.end(), {{low, 0.0}, {high, 0.0}, {high, 4.0}, {low, 4.0}});
      map.cornerUv.push_back({first, first + 1, first + 2});
      map.cornerUv.push_back({first, first + 2, first + 3});
    }
    return measureOverlap(map, 4).share;
  };
  EXPECT_EQ(share(0.0, 1.0), 0.25);
  EXPECT_EQ(share(3.0, 4.0), 0.25);
  EXPECT_EQ(share(0.0, 0.45), 0.0);  // before the first centre, 0.5
  EXPECT_EQ(share(0.45, 0.55), 0.25);
  EXPECT_EQ(share(1.0, 3.0), 0.5);
}

TEST(Overlap, DoesNotDependOnScalePlaceOrOrientation) {
  const UvMap map = twoSheets(6, 2);
  const OverlapFacts asked = measureOverlap(map);
  for (double scale : {1e-200, 1e200, -1.0}) {
    UvMap other = map;
    for (Vec2& p : other.uv) p = {scale * p[0] + 3 * scale, scale * p[1]};
    EXPECT_NEAR(measureOverlap(other).share, asked.share, 0.01) << scale;
  }
}

TEST(Overlap, HandlesMalformedMaps) {
  EXPECT_EQ(measureOverlap({}).layers, 0);
  UvMap map = sheet(2);
  map.uv[4] = {std::numeric_limits<double>::quiet_NaN(), 0};
  map.cornerUv[0] = {-1, 0, 99};
  EXPECT_LE(measureOverlap(map).layers, 1);
  for (Vec2& p : map.uv) p = {1, 1};
  EXPECT_EQ(measureOverlap(map).layers, 0);
}

}  // namespace
}  // namespace hgp
