#include "hgp/field/smooth_field.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>

#include "hgp/cones/cancel_cones.h"
#include "hgp/field/read_holonomy.h"
#include "support/prescriptions.h"
#include "support/shapes.h"

namespace hgp {
namespace {

struct Smooth {
  TriMesh mesh;
  FieldContext context;
  FrameField field;
  CompleteSpec spec;
};

Smooth smoothOf(const test::Shape& shape, int q) {
  Smooth s{shape.mesh(), {}, {}, {}};
  s.context = std::move(*prepareFields(s.mesh));
  SmoothFieldOptions options;
  options.q = q;
  Result<FrameField> field = smoothField(s.mesh, s.context, options);
  EXPECT_TRUE(field) << shape.name;
  s.field = std::move(*field);
  s.spec = specOfField(s.mesh, s.context, s.field);
  return s;
}

TEST(SmoothField, HasTheSmallestConesThatASphereOrACubeNeeds) {
  for (int q : {2, 3, 4, 6}) {
    const Smooth s = smoothOf(test::jittered(test::icosphere(5), 0.02), q);
    EXPECT_EQ(s.spec.cones.size(), 2u * static_cast<std::size_t>(q)) << q;
    for (const ConePoint& cone : s.spec.cones) EXPECT_EQ(cone.k, q - 1);
  }
  // Large enough to be solved on patches of triangles.
  for (int q : {3, 4}) {
    const Smooth s = smoothOf(test::jittered(test::icosphere(32), 0.004), q);
    EXPECT_GT(s.mesh.faceCount(), 20000);
    EXPECT_EQ(s.spec.cones.size(), 2u * static_cast<std::size_t>(q)) << q;
    for (const ConePoint& cone : s.spec.cones) EXPECT_EQ(cone.k, q - 1);
  }
  const Smooth cube = smoothOf(test::cube(4), 4);
  ASSERT_EQ(cube.spec.cones.size(), 8u);
  for (const ConePoint& cone : cube.spec.cones)
    EXPECT_NEAR(cube.context.geometry.angleSum[cone.vertex], 1.5 * kPi, 1e-9);
}

TEST(SmoothField, FollowsTheBoundaryWhereThatIsPossible) {
  const Smooth s = smoothOf(test::grid(5, 3), 4);
  EXPECT_TRUE(s.spec.cones.empty());
  for (HalfedgeId h : s.mesh.halfedges()) {
    if (!s.mesh.isBoundary(h)) continue;
    const double gap = s.field.angle[TriMesh::face(h)] - s.context.geometry.direction[h];
    EXPECT_NEAR(std::remainder(gap, kPi / 2), 0.0, 1e-3);
  }
  EXPECT_EQ(s.spec.turning, std::vector<int>{4});
}

TEST(SmoothField, OfEveryShapeHasACompletePrescriptionThatBalances) {
  for (const test::Shape& shape : test::all()) {
    for (int q : {1, 2, 4, 5}) {
      const Smooth s = smoothOf(shape, q);
      long long sum = 0;
      for (const ConePoint& cone : s.spec.cones) sum += q - cone.k;
      for (int l : s.spec.turning) sum += l;
      EXPECT_EQ(sum, q * shape.eulerCharacteristic()) << shape.name << " " << q;
      EXPECT_EQ(s.spec.handles.size(), static_cast<std::size_t>(2 * shape.genus));
    }
  }
}

TEST(CancelCones, LeavesAPrescriptionThatPassesTheCheckWithTheSameTotal) {
  std::mt19937 random(41);
  for (const test::Shape& shape :
       {test::icosphere(4), test::torus(10, 6), test::doubleTorus(2), test::disk(5)}) {
    const TriMesh mesh = shape.mesh();
    const Result<FieldContext> context = prepareFields(mesh);
    ASSERT_TRUE(context);
    for (int q : {3, 4, 6}) {
      // Noise: many close opposite units beside what the topology needs.
      PerVertex<int> defect(static_cast<std::size_t>(mesh.vertexCount()), 0);
      int left = q * (2 - 2 * shape.genus);
      std::vector<VertexId> inner;
      for (VertexId v : mesh.vertices())
        if (!mesh.isBoundary(v)) inner.push_back(v);
      for (int n = 0; n < 30; ++n) {
        const int unit = n % 2 ? 1 : -1;
        defect[inner[static_cast<std::size_t>(
            test::randomBelow(random, static_cast<int>(inner.size())))]] += unit;
      }
      for (; left != 0; left -= left > 0 ? 1 : -1)
        defect[inner[static_cast<std::size_t>(
            test::randomBelow(random, static_cast<int>(inner.size())))]] += left > 0 ? 1 : -1;
      HolonomySpec spec;
      spec.q = q;
      int noisy = 0;
      for (int d : defect) noisy += d != 0;
      spec.cones = cancelCones(mesh, *context, q, defect, {});
      EXPECT_LE(static_cast<int>(spec.cones.size()), noisy) << shape.name;
      long long before = 0, after = 0;
      for (int d : defect) before += d;
      for (const ConePoint& cone : spec.cones) after += q - cone.k;
      EXPECT_EQ(before, after) << shape.name;
      const auto checked = checkPrescription(mesh, context->topology, spec);
      EXPECT_TRUE(checked) << shape.name << ": " << checked.error().message;
    }
  }
}

}  // namespace
}  // namespace hgp
