#include "hgp/mesh/surface_order.h"

#include <gtest/gtest.h>

#include <set>

#include "hgp/mesh/vectors.h"
#include "support/shapes.h"

namespace hgp {
namespace {

/// The ends of halfedges, which say which these are in any numbering.
std::vector<std::array<Vec3, 2>> endsOf(const TriMesh& mesh, const std::vector<HalfedgeId>& order) {
  std::vector<std::array<Vec3, 2>> ends;
  for (HalfedgeId h : order)
    ends.push_back({mesh.position(mesh.tail(h)), mesh.position(mesh.head(h))});
  return ends;
}

TEST(SurfaceOrder, NamesEveryFaceOnce) {
  for (const test::Shape& shape : test::all()) {
    const TriMesh mesh = shape.mesh();
    std::set<int> faces;
    for (HalfedgeId h : surfaceOrder(mesh)) faces.insert(TriMesh::face(h).i);
    EXPECT_EQ(static_cast<int>(faces.size()), mesh.faceCount()) << shape.name;
    EXPECT_EQ(surfaceOrder(mesh).size(), faces.size()) << shape.name;
  }
}

TEST(SurfaceOrder, IsThatOfTheSurfaceInEveryNumbering) {
  for (const test::Shape& shape : test::all()) {
    test::Shape other = test::scattered(shape);
    for (std::size_t t = 0; t < other.data.triangles.size(); ++t)
      std::rotate(other.data.triangles[t].begin(), other.data.triangles[t].begin() + t % 3,
                  other.data.triangles[t].end());
    const TriMesh mesh = shape.mesh(), same = other.mesh();
    EXPECT_EQ(endsOf(mesh, surfaceOrder(mesh)), endsOf(same, surfaceOrder(same))) << shape.name;
  }
}

TEST(SurfaceOrder, StartsAtTheLongestEdge) {
  const TriMesh mesh = test::pretzel(2, 2).mesh();
  const auto lengthOf = [&](HalfedgeId h) {
    return distance(mesh.position(mesh.tail(h)), mesh.position(mesh.head(h)));
  };
  const double first = lengthOf(surfaceOrder(mesh).front());
  for (HalfedgeId h : mesh.halfedges()) EXPECT_LE(lengthOf(h), first);
}

}  // namespace
}  // namespace hgp
