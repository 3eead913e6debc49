// Creases by dihedral angle.
#include "hgp/features/creases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/creases.h"

namespace hgp {
namespace {

TEST(Creases, AreTheEdgesOfACube) {
  const TriMesh mesh = test::cube(6).mesh();
  EXPECT_EQ(findCreases(mesh), test::creasesOf(mesh));
  EXPECT_EQ(findCreases(mesh).size(), 12u * 6u);
  EXPECT_TRUE(findCreases(mesh, 91.0).empty());
}

TEST(Creases, LeaveOutBoundaryEdges) {
  const TriMesh mesh = test::grid(4, 4).mesh();
  EXPECT_TRUE(findCreases(mesh).empty());
}

/// A sheet of n × n squares, folded along x = n/2 by an angle that `degrees` gives along the fold.
template <class Degrees>
TriMesh folded(int n, const Degrees& degrees) {
  MeshData data = test::grid(n, n).data;
  for (Vec3& p : data.positions) {
    const double beyond = p[0] - 0.5 * n;
    const double angle = degrees(p[1]) * 3.14159265358979 / 180.0;
    if (beyond > 0.0) p = {0.5 * n + beyond * std::cos(angle), p[1], beyond * std::sin(angle)};
  }
  return test::meshOf(data);
}

TEST(Creases, ContinueOverWeakerEdgesToTheNextOne) {
  // The fold has 40° at both ends and 24° in the middle: more than 60 % of 30°.
  const TriMesh mesh = folded(12, [](double y) { return std::fabs(y - 6.0) < 1.5 ? 24.0 : 40.0; });
  const std::vector<EdgeId> creases = findCreases(mesh);
  const auto isOnFold = [&](EdgeId e) {
    const HalfedgeId h = mesh.halfedge(e);
    return mesh.position(mesh.tail(h))[0] == 6.0 && mesh.position(mesh.head(h))[0] == 6.0;
  };
  EXPECT_EQ(std::count_if(creases.begin(), creases.end(), isOnFold), 12);
}

TEST(Creases, ThatEndNowhereAreLeftOutIfTheyAreShort) {
  const auto ridge = [](int last) {
    MeshData data = test::grid(12, 12).data;
    for (Vec3& p : data.positions)
      if (p[0] == 6.0 && p[1] >= 4.0 && p[1] <= last) p[2] = 0.3;
    return test::meshOf(data);
  };
  // The ridge meets itself at 33° and the plane at 17°.
  EXPECT_EQ(test::creasesOf(ridge(6)).size(), 48u + 2u);
  EXPECT_TRUE(findCreases(ridge(6)).empty());
  EXPECT_EQ(findCreases(ridge(7)).size(), 3u);
}

TEST(Creases, MayBeAllEdgesOfATriangle) {
  for (const test::Shape& shape : {test::tetrahedron(), test::octahedron()}) {
    const TriMesh mesh = shape.mesh();
    EXPECT_EQ(static_cast<int>(findCreases(mesh).size()), mesh.edgeCount()) << shape.name;
  }
}

TEST(Creases, RunsEndWhereNotJustTwoEdgesMeet) {
  const TriMesh cube = test::meshOf(test::cube(3).data);
  EXPECT_EQ(countRuns(cube, findCreases(cube)), 12);
  const TriMesh plane = test::grid(4, 3).mesh();
  EXPECT_EQ(countRuns(plane, test::creasesOf(plane)), 1);  // its rim, which is closed
  EXPECT_EQ(countRuns(plane, {}), 0);
  EXPECT_EQ(countRuns(plane, {EdgeId(0)}), 1);
}

}  // namespace
}  // namespace hgp
