#include "hgp/system/weights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/shapes.h"

namespace hgp {
namespace {

TEST(MeanValueWeights, ArePositiveAndAddUpToFloatersFormula) {
  for (const test::Shape& shape : test::all()) {
    const TriMesh mesh = shape.mesh();
    const Geometry geometry = computeGeometry(mesh);
    for (HalfedgeId h : mesh.halfedges()) {
      const CornerWeights own = meanValueWeights(geometry, h);
      EXPECT_GT(own.toHead, 0.0);
      EXPECT_GT(own.toThird, 0.0);
      const HalfedgeId twin = mesh.twin(h);
      if (!twin.isValid()) continue;
      // The angles at the tail on either side of the edge.
      const double alpha = geometry.cornerAngle[h];
      const double beta = geometry.cornerAngle[TriMesh::next(twin)];
      const double w = (std::tan(alpha / 2) + std::tan(beta / 2)) / geometry.length[h];
      const double sum = own.toHead + meanValueWeights(geometry, TriMesh::next(twin)).toThird;
      EXPECT_NEAR(sum, w, 1e-12 * w) << shape.name;
    }
  }
}

TEST(MeanValueWeights, HaveLinearPrecisionOnEveryFlatStar) {
  for (const test::Shape& shape : {test::grid(6, 5), test::jittered(test::disk(5), 0.03),
                                   test::jittered(test::grid(7, 7), 0.2, 9)}) {
    test::Shape flat = shape;
    for (Vec3& p : flat.data.positions) p[2] = 0.0;
    const TriMesh mesh = flat.mesh();
    const Geometry geometry = computeGeometry(mesh);
    for (VertexId v : mesh.vertices()) {
      if (mesh.isBoundary(v)) continue;
      if (std::abs(geometry.angleSum[v] - 2 * kPi) > 1e-9) continue;  // folded over by the jitter
      Complex sum = 0.0;
      double total = 0.0;
      for (HalfedgeId h : outgoingHalfedges(mesh, v)) {
        const CornerWeights w = meanValueWeights(geometry, h);
        const auto at = [&](VertexId u) {
          return Complex(mesh.position(u)[0], mesh.position(u)[1]);
        };
        sum += w.toHead * (at(mesh.head(h)) - at(v));
        sum += w.toThird * (at(mesh.tail(TriMesh::previous(h))) - at(v));
        total += w.toHead + w.toThird;
      }
      EXPECT_LT(std::abs(sum), 1e-11 * total) << shape.name;
    }
  }
}

TEST(CotangentWeights, ArePositiveEqualAtBothEndsAndHalfTheCotangentsWithinTheirBounds) {
  int clamped = 0, between = 0;
  for (const test::Shape& shape : {test::icosphere(3), test::jittered(test::torus(12, 8), 0.2, 3),
                                   test::scattered(test::cube(2)), test::tetrahedron()}) {
    const TriMesh mesh = shape.mesh();
    const Geometry geometry = computeGeometry(mesh);
    for (HalfedgeId h : mesh.halfedges()) {
      const HalfedgeId twin = mesh.twin(h);
      const auto edgeWeight = [&](HalfedgeId from, HalfedgeId other) {
        return cotangentWeights(mesh, geometry, from).toHead +
               cotangentWeights(mesh, geometry, TriMesh::next(other)).toThird;
      };
      const double w = edgeWeight(h, twin);
      EXPECT_GT(w, 0.0);
      EXPECT_EQ(w, edgeWeight(twin, h)) << shape.name;
      const double expected = 0.5 / std::tan(geometry.cornerAngle[TriMesh::previous(h)]) +
                              0.5 / std::tan(geometry.cornerAngle[TriMesh::previous(twin)]);
      const bool isInBounds = expected > 0.01 && expected < 20.0;
      ++(isInBounds ? between : clamped);
      EXPECT_NEAR(w, std::clamp(expected, 0.01, 20.0), 1e-12) << shape.name;
    }
  }
  EXPECT_GT(clamped, 10);
  EXPECT_GT(between, 100);
}

TEST(MeanValueWeights, StayFiniteAndPositiveOnSlivers) {
  const TriMesh mesh = test::meshOf({{{0, 0, 0}, {1, 0, 0}, {0.5, 1e-14, 0}}, {{0, 1, 2}}});
  const Geometry geometry = computeGeometry(mesh);
  for (HalfedgeId h : mesh.halfedges()) {
    const CornerWeights w = meanValueWeights(geometry, h);
    EXPECT_TRUE(std::isfinite(w.toHead) && w.toHead > 0.0);
    EXPECT_TRUE(std::isfinite(w.toThird) && w.toThird > 0.0);
  }
}

}  // namespace
}  // namespace hgp
