#include "hgp/field/angle_structure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hgp/cones/make_room.h"
#include "hgp/field/prescribed_field.h"
#include "support/prescriptions.h"
#include "support/shapes.h"

namespace hgp {
namespace {

struct Asked {
  TriMesh mesh;
  FieldContext context;
  CompleteSpec spec;
  std::optional<PerHalfedge<double>> angles() const { return angleStructure(mesh, context, spec); }
};

Asked ask(const TriMesh& mesh, const HolonomySpec& spec) {
  Result<FieldContext> context = prepareFields(mesh);
  EXPECT_TRUE(context);
  const Result<PrescribedField> field = prescribedField(mesh, *context, spec);
  EXPECT_TRUE(field) << field.error().message;
  return {mesh, std::move(*context), field->spec};
}

Asked ask(const test::Shape& shape, const std::vector<int>& indices) {
  const TriMesh mesh = shape.mesh();
  HolonomySpec spec;
  const auto places = test::spreadVertices(mesh, static_cast<int>(indices.size()));
  for (std::size_t i = 0; i < indices.size(); ++i) spec.cones.push_back({places[i], indices[i]});
  return ask(mesh, spec);
}

void expectSums(const Asked& on, const PerHalfedge<double>& angle) {
  PerVertex<double> sum(static_cast<std::size_t>(on.mesh.vertexCount()), 0.0);
  for (FaceId f : on.mesh.faces()) {
    double all = 0.0;
    for (int k = 0; k < 3; ++k) {
      const HalfedgeId h = TriMesh::halfedge(f, k);
      EXPECT_GT(angle[h], 0.0);
      all += angle[h];
      sum[on.mesh.tail(h)] += angle[h];
    }
    EXPECT_NEAR(all, kPi, 1e-12);
  }
  PerVertex<double> asked(static_cast<std::size_t>(on.mesh.vertexCount()), 2.0 * kPi);
  for (const ConePoint& cone : on.spec.cones) asked[cone.vertex] = turnAngle(cone.k, on.spec.q);
  for (std::size_t i = 0; i < on.context.topology.loops.size(); ++i) {
    double turning = 0.0;
    for (HalfedgeId h : on.context.topology.loops[i].halfedges) {
      turning += kPi - sum[on.mesh.tail(h)];
      asked[on.mesh.tail(h)] = sum[on.mesh.tail(h)];
    }
    EXPECT_NEAR(turning, turnAngle(on.spec.turning[i], on.spec.q), 2e-6);
  }
  for (VertexId v : on.mesh.vertices()) EXPECT_NEAR(sum[v], asked[v], 2e-6);
}

TEST(AngleStructure, HasTheSumsThatAreAsked) {
  const std::vector<int> sphere{1, 1, 2, 3, 5, 3, 2, 7};  // Σ (4 − k) = 8
  for (const Asked& on :
       {ask(test::jittered(test::icosphere(6), 0.02), sphere),
        ask(test::jittered(test::torus(16, 10), 0.05), {3, 5, 2, 6}), ask(test::disk(6), {3, 6, 5}),
        ask(test::jittered(test::annulus(16, 6), 0.02), {2, 7})}) {
    const auto angle = on.angles();
    ASSERT_TRUE(angle);
    expectSums(on, *angle);
  }
}

TEST(AngleStructure, OfAFlatSurfaceHasItsOwnAngles) {
  const Asked on = ask(test::grid(5, 4), {});
  const auto angle = on.angles();
  ASSERT_TRUE(angle);
  for (HalfedgeId h : on.mesh.halfedges())
    EXPECT_NEAR((*angle)[h], on.context.geometry.cornerAngle[h], 1e-6);
}

TEST(AngleStructure, DoesNotExistWhereConesUseUpTheAnglesOfOtherVertices) {
  // Two neighbours of six triangles each, ten in all: 9π fit in, 10π do not.
  const TriMesh mesh = test::jittered(test::icosphere(6), 0.02).mesh();
  VertexId first;
  for (VertexId v : mesh.vertices()) {
    const auto ring = [&](VertexId u) {
      int count = 0;
      for ([[maybe_unused]] HalfedgeId h : outgoingHalfedges(mesh, u)) ++count;
      return count;
    };
    if (ring(v) == 6 && ring(mesh.head(mesh.outgoing(v))) == 6) first = v;
  }
  const VertexId second = mesh.head(mesh.outgoing(first));
  for (const int k : {9, 10}) {
    HolonomySpec spec;
    spec.cones = {{first, k}, {second, k}};
    int missing = 2 * k;  // 8 = Σ (4 − k)
    for (const VertexId v : test::spreadVertices(mesh, 14)) {
      const bool isTaken = std::any_of(spec.cones.begin(), spec.cones.end(),
                                       [&](const ConePoint& c) { return c.vertex == v; });
      if (isTaken || missing == 0) continue;
      const int unit = std::min(missing, 2);
      spec.cones.push_back({v, 4 - unit});
      missing -= unit;
    }
    ASSERT_EQ(missing, 0);
    EXPECT_EQ(ask(mesh, spec).angles().has_value(), k == 9) << "k = " << k;
  }
}

TEST(MakeRoom, MovesOnlyAsManyUnitsAsAnAngleStructureNeeds) {
  const TriMesh mesh = test::jittered(test::icosphere(6), 0.02).mesh();
  const auto isRegular = [&](VertexId v) { return mesh.valence(v) == 6; };
  HolonomySpec spec;
  for (VertexId v : mesh.vertices()) {
    const VertexId beside = mesh.head(mesh.outgoing(v));
    if (!isRegular(v) || !isRegular(beside)) continue;
    spec.cones = {{v, 10}, {beside, 10}};
    break;
  }
  ASSERT_EQ(spec.cones.size(), 2u);
  for (const VertexId v : test::spreadVertices(mesh, 14)) {
    const bool isTaken = v == spec.cones[0].vertex || v == spec.cones[1].vertex;
    if (!isTaken && spec.cones.size() < 12) spec.cones.push_back({v, 2});
  }
  HolonomySpec changed = spec;
  AngleShortageMemo shortages;
  makeRoom(mesh, changed, shortages);
  EXPECT_FALSE(ask(mesh, spec).angles());
  EXPECT_TRUE(ask(mesh, changed).angles());
  int sum = 0, moved = 0;
  for (const ConePoint& cone : changed.cones) {
    sum += 4 - cone.k;
    const auto before = std::find_if(spec.cones.begin(), spec.cones.end(),
                                     [&](const ConePoint& c) { return c.vertex == cone.vertex; });
    moved += std::abs(cone.k - (before == spec.cones.end() ? 4 : before->k));
  }
  EXPECT_EQ(sum, 8) << "Lemma 6.2";
  EXPECT_LE(moved, 4) << "a unit or two";
  HolonomySpec again = changed;
  makeRoom(mesh, again, shortages);
  ASSERT_EQ(again.cones.size(), changed.cones.size());
  for (std::size_t i = 0; i < again.cones.size(); ++i) {
    EXPECT_EQ(again.cones[i].vertex, changed.cones[i].vertex);
    EXPECT_EQ(again.cones[i].k, changed.cones[i].k);
  }
}

}  // namespace
}  // namespace hgp
