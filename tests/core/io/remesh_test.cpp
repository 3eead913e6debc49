// Attributes of new polygons.  Laws: a point of an edge gives the same blend from both triangles; what is linear is exact.
#include "hgp/io/remesh.h"

#include "io_support.h"

namespace hgp::io {
namespace {

TEST(Blend, IsTheSameFromBothTrianglesOfAnEdge) {
  const double w = 0.3;
  EXPECT_EQ(blendOf({4, 9, 2}, {1 - w, w, 0}), blendOf({7, 9, 4}, {0, w, 1 - w}));
  EXPECT_EQ(blendOf({4, 9, 2}, {1 - w, w, 0}).of, (std::array{4, 9, -1}));
}

TEST(Blend, OfOneValueIsThatValue) {
  const std::vector<Vec2> values{{0.1, 0.7}, {1.0 / 3, 0.2}};
  const Blend same = blendOf({1, 1, 1}, {0.1, 0.2, 0.7});
  EXPECT_TRUE(same.isOne());
  EXPECT_EQ(blended(same, values), values[1]);
  EXPECT_EQ(blended(blendOf({0, 1, -1}, {0.0, 1.0, 0.0}), values), values[1]);
}

TEST(Blend, WithoutAValueThatCountsIsNothing) {
  BlendTable table;
  EXPECT_EQ(table.of(blendOf({0, -1, 1}, {0.5, 0.25, 0.25})), -1);
  EXPECT_EQ(table.of(blendOf({0, 1, 2}, {0.5, 0.25, 0.25})), 0);
  EXPECT_EQ(table.of(blendOf({2, 1, 0}, {0.25, 0.25, 0.5})), 0);
}

/// Two triangles of a square with uv 2x + y, x − y, and one point in each.
TEST(Remesh, InterpolatesInTheGivenTriangle) {
  PlainSurface surface;
  surface.mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  surface.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  surface.colors = {{0, 0, 0, 1}, {1, 0, 0, 1}, {1, 1, 0, 1}, {0, 1, 0, 0}};
  surface.materials = {"a", "b"};
  surface.triangleMaterial = {0, 1};
  UvMap uv;
  for (const Vec3& p : surface.mesh.positions) uv.uv.push_back({2 * p[0] + p[1], p[0] - p[1]});
  uv.cornerUv = surface.mesh.triangles;
  Remesh remesh;
  remesh.polygons.positions = {{0.75, 0.25, 0}, {0.25, 0.75, 0}, {1, 1, 0}};
  remesh.polygons.cornerVertex = {0, 2, 1};
  remesh.polygons.start = {0, 3};
  remesh.at = {{0, {0.25, 0.5, 0.25}}, {0, {0, 0, 1}}, {1, {0.25, 0.25, 0.5}}};
  remesh.triangle = {1};
  const PolygonAttributes got = attributesAt(surface, &uv, true, remesh);
  for (std::size_t c = 0; c < 3; ++c) {
    const Vec3& p = remesh.polygons.positions[at(remesh.polygons.cornerVertex[c])];
    EXPECT_EQ(got.uv[at(got.cornerUv[c])], (Vec2{2 * p[0] + p[1], p[0] - p[1]}));
  }
  EXPECT_EQ(got.polygonMaterial, (std::vector<int>{1}));
  EXPECT_NEAR(got.colors[2][1], 1.0, 1e-12);
  EXPECT_EQ(got.colors[1][3], 0.5);
  EXPECT_NEAR(linearFromSrgb(got.colors[0][0]), 0.75, 1e-12);
  EXPECT_TRUE(got.cornerNormal.empty());

  const std::string obj = test::textOf(polygonsAsObj(remesh.polygons, got, "x"));
  EXPECT_NE(obj.find("usemtl b\nf 1/1 3/2 2/3\n"), std::string::npos) << obj;
}

}  // namespace
}  // namespace hgp::io
