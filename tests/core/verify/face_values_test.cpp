#include "hgp/verify/face_values.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/shapes.h"

namespace hgp {
namespace {

/// Triangles with three uv of their own each.
UvMap separate(const std::vector<std::array<Vec2, 3>>& triangles) {
  UvMap map;
  for (const auto& t : triangles) {
    const int first = static_cast<int>(map.uv.size());
    map.uv.insert(map.uv.end(), t.begin(), t.end());
    map.cornerUv.push_back({first, first + 1, first + 2});
  }
  return map;
}

/// Two triangles with one diagonal.
void addSquare(double x, double y, UvMap& map) {
  const int i = static_cast<int>(map.uv.size());
  for (const Vec2& p : {Vec2{x, y}, Vec2{x + 1, y}, Vec2{x + 1, y + 1}, Vec2{x, y + 1}})
    map.uv.push_back(p);
  map.cornerUv.push_back({i, i + 1, i + 2});
  map.cornerUv.push_back({i, i + 2, i + 3});
}

UvMap squares(const std::vector<Vec2>& corners) {
  UvMap map;
  for (const Vec2& p : corners) addSquare(p[0], p[1], map);
  return map;
}

TEST(FaceValues, AreThoseOfAKnownMap) {
  // A flat grid, twice as wide as it was, in which one triangle is mirrored.
  const MeshData mesh = test::grid(3, 3).data;
  UvMap map;
  for (const Vec3& p : mesh.positions) map.uv.push_back({2 * p[0], p[1]});
  map.cornerUv = mesh.triangles;
  const double sign = [&] {
    const auto& t = map.cornerUv[0];
    const auto at = [&](std::size_t k) { return map.uv[static_cast<std::size_t>(t[k])]; };
    return (at(1)[0] - at(0)[0]) * (at(2)[1] - at(0)[1]) -
           (at(1)[1] - at(0)[1]) * (at(2)[0] - at(0)[0]);
  }();
  if (sign < 0)
    for (Vec2& p : map.uv) p[0] = -p[0];
  std::swap(map.cornerUv[4][1], map.cornerUv[4][2]);
  const FaceValues values = measureFaces(mesh, map);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (t != 4) {
      EXPECT_NEAR(values.stretch[t], 2, 1e-5) << t;
    }
    EXPECT_NEAR(values.logArea[t], 0, 1e-6) << t;
  }
  EXPECT_EQ(values.notPositive, std::vector<int>{4});
  EXPECT_NEAR(values.uvArea, 2 * values.surfaceArea, 1e-12);
}

TEST(FaceValues, HandleTrianglesWithoutArea) {
  const MeshData mesh{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 1, 3}}};
  const UvMap map{{{0, 0}, {1, 0}, {0, 1}, {0, 0}}, {{0, 1, 2}, {0, 1, 3}}};
  const FaceValues values = measureFaces(mesh, map);
  for (const float x : values.stretch) EXPECT_TRUE(std::isfinite(x));
  EXPECT_EQ(values.stretch[0], 1.0F);
  EXPECT_EQ(values.logArea[0], 0.0F);
  EXPECT_EQ(values.notPositive, std::vector<int>{1});
}

TEST(OverlapPairs, CountPairsThatShareAreaButNoCorner) {
  EXPECT_EQ(findOverlapPairs(squares({{0, 0}})).pairs, 0);
  EXPECT_EQ(findOverlapPairs(squares({{0, 0}, {1, 0}, {0, 1}, {1, 1}})).pairs, 0);  // they touch
  const OverlapPairs two = findOverlapPairs(squares({{0, 0}, {0.5, 0.25}}));
  EXPECT_EQ(two.pairs, 3);
  EXPECT_EQ(two.triangles, (std::vector<int>{0, 1, 2, 3}));
  EXPECT_FALSE(two.isMore);
  EXPECT_EQ(findOverlapPairs(squares({{0, 0}, {0, 0}, {0, 0}})).pairs, 6);
  EXPECT_EQ(findOverlapPairs({}).pairs, 0);
  const OverlapPairs stopped = findOverlapPairs(squares(std::vector<Vec2>(100, Vec2{0, 0})), 50);
  EXPECT_EQ(stopped.pairs, 50);
  EXPECT_TRUE(stopped.isMore);
}

TEST(OverlapPairs, AgreeWithComparingAllPairs) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> at(0, 10), size(-1, 1);
  std::vector<std::array<Vec2, 3>> triangles;
  for (int i = 0; i < 300; ++i) {
    const Vec2 p{at(random), at(random)};
    const auto near = [&] { return Vec2{p[0] + size(random), p[1] + size(random)}; };
    triangles.push_back({near(), near(), near()});
  }
  long long expected = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t j = i + 1; j < triangles.size(); ++j) {
      UvMap both = separate({triangles[i], triangles[j]});
      expected += findOverlapPairs(both).pairs;
    }
  }
  EXPECT_GT(expected, 100);
  EXPECT_EQ(findOverlapPairs(separate(triangles)).pairs, expected);
}

}  // namespace
}  // namespace hgp
