// What glTF stores of a map: float32 with v from the top, exactly what a certificate must measure.
#include "hgp/io/round_uv.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/shapes.h"

namespace hgp::io {
namespace {

/// One uv per vertex, from a function of the vertex' position.
template <class Function>
UvMap mapOf(const MeshData& mesh, const Function& uv) {
  UvMap map;
  for (const Vec3& p : mesh.positions) map.uv.push_back(uv(p));
  map.cornerUv = mesh.triangles;
  return map;
}

int flipped(const UvMap& map) {
  int count = 0;
  for (const auto& c : map.cornerUv) {
    const auto at = [&](std::size_t k) { return map.uv[static_cast<std::size_t>(c[k])]; };
    const Vec2 a = at(0), b = at(1), d = at(2);
    if (!((b[0] - a[0]) * (d[1] - a[1]) - (b[1] - a[1]) * (d[0] - a[0]) > 0)) ++count;
  }
  return count;
}

/// Stored and read back, every uv is bit for bit the one that was verified, in float32 either way up.
void expectExact(const UvMap& map) {
  for (const Vec2& uv : map.uv) {
    const auto u = static_cast<float>(uv[0]);
    const auto top = static_cast<float>(1.0 - uv[1]);
    EXPECT_EQ(static_cast<double>(u), uv[0]);
    EXPECT_EQ(1.0 - static_cast<double>(top), uv[1]);
    EXPECT_EQ(static_cast<double>(static_cast<float>(uv[1])), uv[1]);
  }
}

TEST(RoundUv, StoredUvComeBackBitForBit) {
  const MeshData mesh = test::disk(8).data;
  for (double scale : {1e-6, 0.3, 1.0, 977.0, 1e9}) {
    for (double shift : {0.0, 0.5, 1234.5, -1e5}) {
      const UvMap map = mapOf(mesh, [&](const Vec3& p) {
        return Vec2{scale * p[0] + shift * scale, scale * p[1] - shift * scale};
      });
      ASSERT_EQ(flipped(map), 0);
      const UvMap stored = roundToFloat32(mesh, map);
      expectExact(stored);
      EXPECT_EQ(flipped(stored), 0) << scale << " " << shift;
      EXPECT_EQ(roundToFloat32(mesh, stored).uv, stored.uv) << "rounding twice is rounding once";
    }
  }
}

TEST(RoundUv, KeepsWhatIsOnAGridAlready) {
  const MeshData mesh = test::grid(6, 5).data;
  const UvMap map = mapOf(mesh, [](const Vec3& p) { return Vec2{p[0] / 64 + 3, p[1] / 128 - 2}; });
  EXPECT_EQ(roundToFloat32(mesh, map).uv, map.uv);
}

TEST(RoundUv, MovesAndScalesMapsFarFromTheOrigin) {
  // At 10⁶ a float32 has steps of 1/16: nothing of this map would survive where it is.
  const MeshData mesh = test::disk(10).data;
  const UvMap map = mapOf(mesh, [](const Vec3& p) {
    return Vec2{1e6 + p[0] / 8, -1e6 + p[1] / 8};
  });
  ASSERT_EQ(flipped(map), 0);
  const UvMap stored = roundToFloat32(mesh, map);
  expectExact(stored);
  EXPECT_EQ(flipped(stored), 0);
}

TEST(RoundUv, MovesInnerVerticesOfSlivers) {
  // Rows squeezed to a hundred-millionth: rounding alone turns some of them over.
  test::Shape shape = test::jittered(test::grid(12, 12), 0.3, 5);
  const UvMap map = mapOf(shape.data, [](const Vec3& p) {
    return Vec2{p[0], p[1] < 6 ? p[1] : 6 + (p[1] - 6) * 4e-7};
  });
  const UvMap stored = roundToFloat32(shape.data, map);
  expectExact(stored);
  UvMap naive = map;
  for (Vec2& uv : naive.uv) {
    for (double& x : uv) x = static_cast<double>(static_cast<float>(x));
  }
  ASSERT_GT(flipped(naive), 0) << "else this shows nothing";
  EXPECT_LT(flipped(stored), flipped(naive));
}

TEST(RoundUv, SeamsStayRotationsWithinTwoSteps) {
  // Two copies of a row of vertices, related by a quarter turn and a translation.
  const MeshData mesh = test::grid(1, 40).data;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(0.0, 1.0);
  for (int trial = 0; trial < 20; ++trial) {
    const Vec2 shift{7 * number(random), 3 * number(random)};
    UvMap map;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      auto& corners = map.cornerUv.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3& p = mesh.positions[static_cast<std::size_t>(mesh.triangles[t][k])];
        const bool isTurned = t % 2 == 1;
        corners[k] = static_cast<int>(map.uv.size());
        map.uv.push_back(isTurned ? Vec2{shift[0] - p[1], shift[1] + p[0]} : Vec2{p[0], p[1]});
      }
    }
    const UvMap stored = roundToFloat32(mesh, map);
    double largest = 0;
    for (const Vec2& uv : stored.uv)
      largest = std::max({largest, std::abs(uv[0]), std::abs(uv[1])});
    const double step = std::ldexp(1.0, std::ilogb(largest) - 23);
    for (std::size_t i = 0; i < map.uv.size(); ++i) {
      for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_NEAR(stored.uv[i][k], map.uv[i][k], step);
      }
    }
  }
}

TEST(RoundUv, LeavesWhatCannotBeRounded) {
  const MeshData mesh = test::triangle().data;
  UvMap map = mapOf(mesh, [](const Vec3& p) { return Vec2{p[0], p[1]}; });
  map.uv[0][0] = std::nan("");
  EXPECT_TRUE(std::isnan(roundToFloat32(mesh, map).uv[0][0]));
  map.uv[0][0] = 0;
  map.cornerUv[0][1] = -1;
  EXPECT_EQ(roundToFloat32(mesh, map).cornerUv, map.cornerUv);
  map.cornerUv.clear();
  EXPECT_TRUE(roundToFloat32(mesh, map).cornerUv.empty());
}

/// A disk of tiny triangles far from the origin, where its neighbours' grid is far too coarse.
TEST(RoundUv, AComponentIsRoundedAsIfItWereAlone) {
  const MeshData one = test::disk(8).data;
  MeshData mesh = one;
  const auto first = static_cast<int>(one.positions.size());
  for (Vec3 p : one.positions) mesh.positions.push_back({p[0], p[1], 1.0});
  for (auto t : one.triangles) mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  const auto place = [](const Vec3& p) {
    return p[2] == 1.0 ? Vec2{1e-5 * p[0] + 3e-6, 1e-5 * p[1]} : Vec2{1e5 * p[0] + 3e7, 1e5 * p[1]};
  };
  const UvMap both = roundToFloat32(mesh, mapOf(mesh, place));
  EXPECT_EQ(flipped(both), 0);
  expectExact(both);
  const UvMap alone = roundToFloat32(one, mapOf(one, [](const Vec3& p) {
                                       return Vec2{1e-5 * p[0] + 3e-6, 1e-5 * p[1]};
                                     }));
  for (std::size_t i = 0; i < alone.uv.size(); ++i) {
    EXPECT_EQ(both.uv[static_cast<std::size_t>(first) + i], alone.uv[i]);
  }
  const UvMap again = roundToFloat32(mesh, both);
  EXPECT_EQ(again.uv, both.uv);
}

TEST(RoundUv, PartsThatShareAnEdgeOfTheSurfaceHaveGridsOfTheirOwn) {
  // Two disks of the same vertices: one near the origin, one large and far from it.
  MeshData mesh = test::disk(5).data;
  const std::vector<std::array<int, 3>> once = mesh.triangles;
  UvMap map = mapOf(mesh, [](const Vec3& p) { return Vec2{2 * p[0] / 3, 3 * p[1] / 7}; });
  std::vector<int> partOf(once.size(), 0);
  const auto half = static_cast<int>(map.uv.size());
  for (int i = 0; i < half; ++i) {
    const Vec3& p = mesh.positions[static_cast<std::size_t>(i)];
    map.uv.push_back({1e4 * p[0] / 3 + 5e4, 1e4 * p[1] / 7});
  }
  for (const auto& t : once) {
    mesh.triangles.push_back(t);
    map.cornerUv.push_back({t[0] + half, t[1] + half, t[2] + half});
    partOf.push_back(1);
  }
  // A triangle that follows the first part, with a corner of its own.
  mesh.triangles.push_back(once[0]);
  map.uv.push_back({map.uv[static_cast<std::size_t>(once[0][2])][0] + 1.0 / 64,
                    map.uv[static_cast<std::size_t>(once[0][2])][1]});
  map.cornerUv.push_back({once[0][0], once[0][1], static_cast<int>(map.uv.size()) - 1});
  partOf.push_back(-1);
  const UvMap stored = roundToFloat32(mesh, map, partOf);
  expectExact(stored);
  EXPECT_EQ(flipped(stored), flipped(map));
  double largest = 0;
  for (int i = 0; i < half; ++i)
    for (std::size_t k = 0; k < 2; ++k)
      largest = std::max(largest, std::abs(stored.uv[static_cast<std::size_t>(i)][k] -
                                           map.uv[static_cast<std::size_t>(i)][k] -
                                           stored.uv[0][k] + map.uv[0][k]));
  EXPECT_LT(largest, 2e-7);
  EXPECT_GT(std::abs(roundToFloat32(mesh, map).uv[1][0] - map.uv[1][0] -
                     roundToFloat32(mesh, map).uv[0][0] + map.uv[0][0]),
            2e-7);
  EXPECT_EQ(roundToFloat32(mesh, stored, partOf).uv, stored.uv);
}

}  // namespace
}  // namespace hgp::io
