#include "hgp/field/cone_angles.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "hgp/base/turns.h"
#include "hgp/field/prescribed_field.h"
#include "support/prescriptions.h"
#include "support/shapes.h"

namespace hgp {
namespace {

/// Every given loop as a question has it.
std::vector<LoopAngle> loopsOf(const Topology& topology, const CompleteSpec& spec) {
  std::vector<LoopAngle> out;
  for (std::size_t j = 0; j < topology.loops.size(); ++j)
    out.push_back({static_cast<int>(j), &topology.loops[j], spec.turning[j]});
  return out;
}

TEST(ConeAngles, SumToWhatIsAskedAndToPiInEveryTriangle) {
  std::mt19937 random(5);
  int laws = 0;
  for (const test::Shape& shape : test::all()) {
    const TriMesh mesh = shape.mesh();
    const Result<FieldContext> context = prepareFields(mesh);
    ASSERT_TRUE(context) << shape.name;
    const auto spec = test::randomSpec(mesh, context->topology, {4, 4, false, false}, random);
    if (!spec) continue;
    const Result<PrescribedField> field = prescribedField(mesh, *context, *spec);
    if (!field) continue;
    PerVertex<int> k(static_cast<std::size_t>(mesh.vertexCount()), 4);
    for (const ConePoint& cone : spec->cones) k[cone.vertex] = cone.k;
    const AngleQuestion question{4, k, loopsOf(context->topology, field->spec)};
    const PerHalfedge<double> angle = coneAngles(mesh, *context, question);
    PerVertex<double> sum(static_cast<std::size_t>(mesh.vertexCount()), 0.0);
    for (FaceId f : mesh.faces()) {
      double all = 0.0;
      for (int i = 0; i < 3; ++i) {
        const HalfedgeId h = TriMesh::halfedge(f, i);
        all += angle[h];
        sum[mesh.tail(h)] += angle[h];
      }
      EXPECT_NEAR(all, kPi, 1e-9) << shape.name;
    }
    for (VertexId v : mesh.vertices()) {
      if (!context->surface.isInterior(mesh, v)) continue;
      EXPECT_NEAR(sum[v], turnAngle(k[v], 4), 1e-8) << shape.name << " vertex " << v.i;
    }
    for (const LoopAngle& loop : question.loops) {
      double turn = 0.0;
      for (HalfedgeId h : loop.loop->halfedges) turn += kPi - sum[mesh.tail(h)];
      EXPECT_NEAR(turn, turnAngle(loop.turning, 4), 1e-8) << shape.name << " loop " << loop.index;
    }
    ++laws;
  }
  EXPECT_GE(laws, 10);
}

TEST(ConeAngles, OfLoopsThatAreOpenTakeTheRest) {
  const TriMesh mesh = test::annulus(8, 6).mesh();
  const Result<FieldContext> context = prepareFields(mesh);
  ASSERT_TRUE(context);
  PerVertex<int> k(static_cast<std::size_t>(mesh.vertexCount()), 4);
  const auto inner = [&](VertexId v) { return context->surface.isInterior(mesh, v); };
  VertexId cone;
  for (VertexId v : mesh.vertices())
    if (!cone.isValid() && inner(v)) cone = v;
  k[cone] = 3;
  const PerHalfedge<double> angle = coneAngles(mesh, *context, {4, k, {}});
  PerVertex<double> sum(static_cast<std::size_t>(mesh.vertexCount()), 0.0);
  for (FaceId f : mesh.faces())
    for (int i = 0; i < 3; ++i)
      sum[mesh.tail(TriMesh::halfedge(f, i))] += angle[TriMesh::halfedge(f, i)];
  for (VertexId v : mesh.vertices())
    if (inner(v)) {
      EXPECT_NEAR(sum[v], turnAngle(k[v], 4), 1e-9);
    }
}

}  // namespace
}  // namespace hgp
