// Tutte's theorem [BCW17 Thm 3.1]: a convex combination map of a disk onto a convex polygon is an
// embedding.
#include <gtest/gtest.h>

#include <cmath>

#include "hgp/mesh/geometry.h"
#include "hgp/parametrize/parametrize.h"
#include "support/shapes.h"

namespace hgp {
namespace {

std::vector<test::Shape> disks() {
  return {test::triangle(),
          test::grid(4, 3),
          test::disk(1),
          test::disk(6),
          test::jittered(test::disk(8), 0.05),
          test::withoutFaces(test::icosphere(4), {0}),
          test::withoutFaces(test::jittered(test::icosphere(5), 0.06), {7}),
          test::withoutFaces(test::cube(5), {3})};
}

TEST(Tutte, EmbedsEveryDiskOntoAConvexPolygon) {
  for (const test::Shape& shape : disks()) {
    const TriMesh mesh = shape.mesh();
    const Result<Parametrization> p = parametrizeConvex(mesh, {});
    ASSERT_TRUE(p) << shape.name << ": " << p.error().message;
    EXPECT_TRUE(p->isCertified) << shape.name;
    EXPECT_EQ(p->certificate.seams.chartCount, 1);
    EXPECT_TRUE(p->certificate.seams.seams.empty());
    ASSERT_EQ(p->certificate.angles.turnings.size(), 1u);
    EXPECT_EQ(p->certificate.angles.turnings[0].measured, p->spec.q) << "one full turn";
  }
}

TEST(Tutte, BoundaryVerticesLieOnACircleInTheirOrder) {
  for (const test::Shape& shape : disks()) {
    const TriMesh mesh = shape.mesh();
    const Result<Parametrization> p = parametrizeConvex(mesh, {});
    ASSERT_TRUE(p);
    const Topology topology = computeTopology(mesh);
    std::vector<Complex> polygon;
    for (HalfedgeId h : topology.loops[0].halfedges) {
      const int copy = p->map.cornerUv[static_cast<std::size_t>(TriMesh::face(h).i)]
                                      [static_cast<std::size_t>(h.i % 3)];
      const Vec2& uv = p->map.uv[static_cast<std::size_t>(copy)];
      polygon.emplace_back(uv[0], uv[1]);
    }
    double turned = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Complex a = polygon[i], b = polygon[(i + 1) % polygon.size()],
                    c = polygon[(i + 2) % polygon.size()];
      const double angle = std::arg((c - b) / (b - a));
      EXPECT_GT(angle, 0.0) << shape.name << ": strictly convex";
      turned += angle;
    }
    EXPECT_NEAR(turned, 2 * kPi, 1e-9) << shape.name;
  }
}

TEST(Tutte, InteriorVerticesAreTheMeanValueAverageOfTheirNeighbours) {
  const TriMesh mesh = test::jittered(test::disk(6), 0.05).mesh();
  const Geometry geometry = computeGeometry(mesh);
  const Result<Parametrization> p = parametrizeConvex(mesh, {});
  ASSERT_TRUE(p);
  PerVertex<Complex> z(static_cast<std::size_t>(mesh.vertexCount()));
  for (std::size_t c = 0; c < p->map.uv.size(); ++c)
    z[p->copyOf[c]] = {p->map.uv[c][0], p->map.uv[c][1]};
  for (VertexId v : mesh.vertices()) {
    if (mesh.isBoundary(v)) continue;
    Complex sum = 0.0;
    double total = 0.0;
    for (HalfedgeId h : outgoingHalfedges(mesh, v)) {
      const double w = (std::tan(geometry.cornerAngle[h] / 2) +
                        std::tan(geometry.cornerAngle[TriMesh::next(mesh.twin(h))] / 2)) /
                       geometry.length[h];
      sum += w * (z[mesh.head(h)] - z[v]);
      total += w;
    }
    EXPECT_LT(std::abs(sum), 1e-11 * total);
  }
}

}  // namespace
}  // namespace hgp
