#include "conformal_metric.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/optimize/solved.h"
#include "unfold.h"

namespace hgp::bench {
namespace {

ConformalMetric metricOf(const TriMesh& mesh, const FieldContext& context,
                         const CompleteSpec& spec) {
  return conformalMetric(mesh, context.geometry, context.topology, context.surface, spec, {});
}

/// Angle sums per vertex of a metric, by the law of cosines.
PerVertex<double> angleSums(const TriMesh& mesh, const PerHalfedge<double>& length) {
  PerVertex<double> sum(static_cast<std::size_t>(mesh.vertexCount()), 0.0);
  for (FaceId f : mesh.faces())
    for (int k = 0; k < 3; ++k) {
      const HalfedgeId h = TriMesh::halfedge(f, k);
      const double a = length[TriMesh::next(h)], b = length[h], c = length[TriMesh::previous(h)];
      sum[mesh.tail(h)] += std::acos((b * b + c * c - a * a) / (2 * b * c));
    }
  return sum;
}

/// The largest difference of an edge's length and that of its image, relative to it.
double lengthError(const TriMesh& mesh, const CutMesh& cut, const PerHalfedge<double>& length,
                   const std::vector<Complex>& z) {
  double worst = 0.0;
  for (FaceId f : mesh.faces())
    for (int k = 0; k < 3; ++k) {
      const HalfedgeId h = TriMesh::halfedge(f, k);
      const Complex a = z[static_cast<std::size_t>(cut.copy[h].i)],
                    b = z[static_cast<std::size_t>(cut.copy[TriMesh::next(h)].i)];
      worst = std::max(worst, std::fabs(std::abs(b - a) / length[h] - 1.0));
    }
  return worst;
}

TEST(ConformalMetric, HasTheConesAndTurningThatAreAskedOnEverySurface) {
  int found = 0, tried = 0;
  for (const test::CutSurface& surface : test::makeCutSurfaces(11)) {
    const CompleteSpec& spec = surface.field.spec;
    const ConformalMetric metric = metricOf(surface.mesh, surface.context, spec);
    ++tried;
    EXPECT_EQ(metric.isFound, metric.broken == 0) << surface.name << ": " << metric.residual;
    if (!metric.isFound) continue;
    ++found;
    EXPECT_LE(metric.steps, 30) << surface.name;
    const PerVertex<double> sum = angleSums(surface.mesh, metric.length);
    PerVertex<double> asked(sum.size(), 2.0 * kPi);
    for (const ConePoint& cone : spec.cones) asked[cone.vertex] = turnAngle(cone.k, spec.q);
    for (VertexId v : surface.mesh.vertices()) {
      if (surface.mesh.isBoundary(v)) continue;
      EXPECT_NEAR(sum[v], asked[v], 1e-7) << surface.name;
    }
    for (std::size_t j = 0; j < surface.context.topology.loops.size(); ++j) {
      double turning = 0.0;
      for (HalfedgeId h : surface.context.topology.loops[j].halfedges)
        turning += kPi - sum[surface.mesh.tail(h)];
      EXPECT_NEAR(turning, turnAngle(spec.turning[j], spec.q), 1e-7) << surface.name;
    }
  }
  EXPECT_GT(3 * found, tried) << found << " of " << tried;
}

TEST(ConformalMetric, LaidOutIsSeamlessWhereThereAreNoHandles) {
  int certified = 0;
  for (test::CutSurface& made : test::makeCutSurfaces(12)) {
    const test::SeamlessProblem problem{std::move(made), {}, {}};
    const test::CutSurface& surface = problem.surface;
    const ConformalMetric metric = metricOf(surface.mesh, surface.context, surface.field.spec);
    if (!metric.isFound) continue;
    const std::vector<Complex> z = unfold(surface.mesh, surface.cut, metric.length);
    EXPECT_LT(lengthError(surface.mesh, surface.cut, metric.length, z), 1e-7) << surface.name;
    const Certificate certificate = problem.certify(z);
    EXPECT_EQ(certificate.orientation.zero + certificate.orientation.negative, 0) << surface.name;
    if (surface.context.topology.genus > 0) continue;
    EXPECT_TRUE(certificate.isCertified) << surface.name;
    certified += certificate.isCertified;
  }
  EXPECT_GE(certified, 3);
}

TEST(ConformalMetric, OfAFlatDiskIsItsOwn) {
  test::Shape shape = test::jittered(test::disk(8), 0.02);
  for (Vec3& p : shape.data.positions) p[2] = 0.0;
  const TriMesh mesh = shape.mesh();
  const FieldContext context = prepareSurface(mesh);
  const ConformalMetric metric = metricOf(mesh, context, {4, {}, {4}, {}});
  ASSERT_TRUE(metric.isFound);
  for (FaceId f : mesh.faces())
    for (int k = 0; k < 3; ++k) {
      const HalfedgeId h = TriMesh::halfedge(f, k);
      EXPECT_NEAR(metric.length[h], context.geometry.length[h], 1e-9);
    }
}

TEST(ConformalMetric, StopsAndReportsWhenTrianglesDegenerate) {
  // Five triangles cannot sum to 6π at their common vertex, whatever their lengths.
  const TriMesh mesh = test::icosphere(1).mesh();
  const FieldContext context = prepareSurface(mesh);
  CompleteSpec spec{2, {{VertexId(0), 6}}, {}, {}};
  for (int v = 1; v <= 8; ++v) spec.cones.push_back({VertexId(v), 1});
  ASSERT_EQ(mesh.valence(VertexId(0)), 5);
  const ConformalMetric metric = metricOf(mesh, context, spec);
  EXPECT_FALSE(metric.isFound);
  EXPECT_GT(metric.broken, 0);
}

}  // namespace
}  // namespace hgp::bench
