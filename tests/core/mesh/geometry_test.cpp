#include "hgp/mesh/geometry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hgp/mesh/topology.h"
#include "support/shapes.h"

namespace hgp {
namespace {

TEST(Geometry, AnglesOfEveryTriangleAddUpToAHalfTurn) {
  for (const test::Shape& shape : test::all()) {
    const TriMesh mesh = shape.mesh();
    const Geometry g = computeGeometry(mesh);
    for (FaceId f : mesh.faces()) {
      double sum = 0.0;
      for (int k = 0; k < 3; ++k) sum += g.cornerAngle[TriMesh::halfedge(f, k)];
      EXPECT_NEAR(sum, kPi, 1e-14);
      EXPECT_GT(g.area[f], 0.0);
    }
  }
}

TEST(Geometry, CurvatureAddsUpToTheEulerCharacteristic) {
  for (const test::Shape& shape : test::all()) {
    const TriMesh mesh = shape.mesh();
    const Geometry g = computeGeometry(mesh);
    double sum = 0.0;
    for (VertexId v : mesh.vertices()) sum += curvature(mesh, g, v);
    EXPECT_NEAR(sum, 2 * kPi * shape.eulerCharacteristic(), 1e-12 * mesh.faceCount()) << shape.name;
  }
}

TEST(Geometry, TransportAroundAVertexIsItsCurvature) {
  // A direction carried once counterclockwise around v comes back turned by the curvature.
  for (const test::Shape& shape : test::all()) {
    const TriMesh mesh = shape.mesh();
    const Geometry g = computeGeometry(mesh);
    for (VertexId v : mesh.vertices()) {
      if (mesh.isBoundary(v)) continue;
      double turned = 0.0;
      for (HalfedgeId h : outgoingHalfedges(mesh, v))
        turned += transport(mesh, g, TriMesh::previous(h));
      EXPECT_NEAR(principalAngle(turned - curvature(mesh, g, v)), 0.0, 1e-12) << shape.name;
    }
  }
}

TEST(Geometry, TransportThereAndBackIsZero) {
  const TriMesh mesh = test::jittered(test::torus(12, 7), 0.05).mesh();
  const Geometry g = computeGeometry(mesh);
  for (HalfedgeId h : mesh.halfedges())
    EXPECT_NEAR(principalAngle(transport(mesh, g, h) + transport(mesh, g, mesh.twin(h))), 0, 1e-13);
}

TEST(Geometry, EvenedLengthsAreAMetricWithoutThinTriangles) {
  for (const double factor : {1.0, 1e3, 1e6}) {
    test::Shape shape = test::jittered(test::pretzel(2, 3), 0.03);
    for (auto& p : shape.data.positions) p[1] *= factor;
    const TriMesh mesh = shape.mesh();
    const Geometry own = computeGeometry(mesh, 0.0), even = evenedGeometry(mesh);
    EXPECT_EQ(even.unit, own.unit);
    double sum = 0.0;
    for (VertexId v : mesh.vertices()) sum += curvature(mesh, even, v);
    EXPECT_NEAR(sum, 2 * kPi * shape.eulerCharacteristic(), 1e-12 * mesh.faceCount());
    for (HalfedgeId h : mesh.halfedges())
      EXPECT_NEAR(even.length[h], std::sqrt(own.length[h] * own.length[h] + 1.0),
                  1e-9 * even.length[h]);
    for (FaceId f : mesh.faces()) {
      double longest = 0.0;
      for (int k = 0; k < 3; ++k) longest = std::max(longest, even.length[TriMesh::halfedge(f, k)]);
      EXPECT_LT(longest * longest, 20.0 * 2.0 * even.area[f]);
    }
  }
}

TEST(Geometry, LengthsAreInUnitsOfTheMeanEdge) {
  for (double scale : {1e-6, 1.0, 1e9}) {
    test::Shape shape = test::icosphere(3);
    for (Vec3& p : shape.data.positions)
      for (double& x : p) x *= scale;
    const TriMesh mesh = shape.mesh();
    const Geometry g = computeGeometry(mesh);
    double sum = 0.0;
    for (EdgeId e : mesh.edges()) {
      sum += g.length[mesh.halfedge(e)];
      const HalfedgeId twin = mesh.twin(mesh.halfedge(e));
      EXPECT_NEAR(g.length[mesh.halfedge(e)], g.length[twin], 1e-14);
    }
    EXPECT_NEAR(sum / mesh.edgeCount(), 1.0, 1e-13);
    double angles = 0.0;
    for (VertexId v : mesh.vertices()) angles += g.angleSum[v];
    EXPECT_NEAR(angles, kPi * mesh.faceCount(), 1e-10);
  }
}

TEST(Geometry, SliversAreRaisedToTheHeightBound) {
  MeshData data{{{0, 0, 0}, {2, 0, 0}, {1, 1e-12, 0}}, {{0, 1, 2}}};
  for (int turn = 0; turn < 3; ++turn) {
    std::rotate(data.triangles[0].begin(), data.triangles[0].begin() + 1, data.triangles[0].end());
    const TriMesh mesh = test::meshOf(data);
    const Geometry g = computeGeometry(mesh, 1e-6);
    double longest = 0.0;
    for (HalfedgeId h : mesh.halfedges()) longest = std::max(longest, g.length[h]);
    EXPECT_GE(2 * g.area[FaceId(0)] / (longest * longest), 0.99e-6);
    EXPECT_LE(2 * g.area[FaceId(0)] / (longest * longest), 2e-6);
  }
}

}  // namespace
}  // namespace hgp
