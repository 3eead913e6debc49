// Corners of a rectangle: where the rim turns, evenly where it turns alike, whatever the loop begins with.
#include "hgp/features/rectangle_corners.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "support/shapes.h"

namespace hgp {
namespace {

std::set<int> cornersOf(const TriMesh& mesh, std::size_t rotation = 0) {
  Topology topology = computeTopology(mesh);
  std::vector<HalfedgeId>& loop = topology.loops.at(0).halfedges;
  std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(rotation % loop.size()),
              loop.end());
  const auto corners = rectangleCorners(mesh, computeGeometry(mesh), topology.loops[0]);
  std::set<int> ids;
  if (corners)
    for (VertexId v : *corners) ids.insert(v.i);
  return ids;
}

/// The vertices of a mesh in the plane that are extreme in both coordinates.
std::set<int> extremes(const TriMesh& mesh) {
  double low[2] = {1e9, 1e9}, high[2] = {-1e9, -1e9};
  for (VertexId v : mesh.vertices())
    for (int k = 0; k < 2; ++k) {
      low[k] = std::min(low[k], mesh.position(v)[at(k)]);
      high[k] = std::max(high[k], mesh.position(v)[at(k)]);
    }
  std::set<int> ids;
  for (VertexId v : mesh.vertices()) {
    const Vec3& p = mesh.position(v);
    if ((p[0] == low[0] || p[0] == high[0]) && (p[1] == low[1] || p[1] == high[1])) ids.insert(v.i);
  }
  return ids;
}

TEST(RectangleCorners, AreThoseOfARectangleWhereverItsLoopBegins) {
  for (const auto& [m, n] :
       {std::pair(9, 6), std::pair(40, 3), std::pair(5, 5), std::pair(200, 1), std::pair(1, 1)}) {
    const TriMesh mesh = test::meshOf(test::grid(m, n).data);
    const std::set<int> expected = extremes(mesh);
    ASSERT_EQ(expected.size(), 4u);
    for (std::size_t rotation : {0, 1, 7, 13}) EXPECT_EQ(cornersOf(mesh, rotation), expected);
  }
}

/// A disk of a centre and n vertices on a circle.
TriMesh fan(int n) {
  MeshData data;
  data.positions.push_back({0, 0, 0});
  for (int i = 0; i < n; ++i)
    data.positions.push_back({std::cos(2.0 * kPi * i / n), std::sin(2.0 * kPi * i / n), 0});
  for (int i = 0; i < n; ++i) data.triangles.push_back({0, 1 + i, 1 + (i + 1) % n});
  return test::meshOf(data);
}

TEST(RectangleCorners, AreEvenlySpacedOnACircle) {
  const std::set<int> ids = cornersOf(fan(400));
  ASSERT_EQ(ids.size(), 4u);
  std::vector<int> sorted(ids.begin(), ids.end());
  for (int i = 0; i < 4; ++i)
    EXPECT_NEAR((sorted[at((i + 1) % 4)] - sorted[at(i)] + 400) % 400, 100, 8) << i;
}

TEST(RectangleCorners, NeedARimOfFourEdges) {
  EXPECT_TRUE(cornersOf(fan(3)).empty());
  EXPECT_EQ(cornersOf(fan(4)).size(), 4u);
}

}  // namespace
}  // namespace hgp
