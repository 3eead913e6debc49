#include "hgp/parametrize/repair_plan.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "hgp/optimize/frames.h"
#include "support/prescriptions.h"
#include "support/shapes.h"

namespace hgp {
namespace {

/// A sphere with eight cones of 3π/2, ready to be solved.
struct Prepared {
  TriMesh mesh;
  SeamlessSetup setup;
  std::vector<FaceId> coneFaces;
};

Prepared sphere(int n) {
  Prepared out{test::icosphere(n).mesh(), {}, {}};
  HolonomySpec spec;
  for (VertexId v : test::spreadVertices(out.mesh, 8)) spec.cones.push_back({v, 3});
  std::vector<StageTime> times;
  PreparedSurface surface(out.mesh);
  auto setup = prepareSeamless(surface, spec, {}, times);
  EXPECT_TRUE(setup) << setup.error().message;
  out.setup = std::move(*setup);
  out.coneFaces = coneAndBoundaryFaces(out.mesh, out.setup.cones);
  return out;
}

/// A program whose map has so many triangles wrong, the first ones of the mesh, and whose unknowns
/// are all `value`.
void tell(RepairPlan& plan, const Prepared& on, int wrong, double value) {
  ProgramResult program;
  program.x = Eigen::VectorXcd::Constant(on.setup.unknowns.count, value);
  Certificate certificate;
  certificate.isMeasured = true;
  for (int f = 0; f < wrong; ++f) certificate.orientation.notPositive.push_back(FaceId(f));
  plan.learn(program, certificate);
}

int freeCount(const RepairStep& step) {
  return static_cast<int>(
      std::count(step.local->isFree.begin(), step.local->isFree.end(), char{1}));
}

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

TEST(RepairPlan, PullsARingMoreWhereTheDenseSystemStaysSmall) {
  const Prepared small = sphere(8), large = sphere(32);
  RepairPlan forSmall(small.mesh, small.setup, false);
  EXPECT_EQ(forSmall.next()->pulled, small.coneFaces);
  RepairPlan forLarge(large.mesh, large.setup, false);
  EXPECT_EQ(forLarge.next()->pulled, growFaces(large.mesh, large.coneFaces, 1));
}

TEST(RepairPlan, MendsAPatchWidensItWhereThatMadeItWorseAndThenBindsEverything) {
  const Prepared on = sphere(32);
  RepairPlan plan(on.mesh, on.setup, false);
  EXPECT_FALSE(plan.next()->local);
  tell(plan, on, 2, 1.0);

  const std::optional<RepairStep> patch = plan.next();
  ASSERT_TRUE(patch && patch->local) << "two wrong triangles need no program of everything";
  EXPECT_TRUE(endsWith(patch->method, "growth 1, locally")) << patch->method;
  EXPECT_EQ(patch->local->x[0], 1.0);
  const auto bound = growFaces(on.mesh, {FaceId(0), FaceId(1)}, 1);
  EXPECT_EQ(patch->frames.faces, bound);

  tell(plan, on, 5, 2.0);  // worse
  const std::optional<RepairStep> wide = plan.next();
  ASSERT_TRUE(wide && wide->local);
  EXPECT_TRUE(endsWith(wide->method, "growth 1, on a wide patch")) << wide->method;
  EXPECT_EQ(wide->local->x[0], 1.0) << "the map before the one that was worse";
  EXPECT_EQ(wide->frames.faces, bound);
  EXPECT_GT(freeCount(*wide), 3 * freeCount(*patch));

  tell(plan, on, 2, 3.0);  // no worse: on from there
  const std::optional<RepairStep> on2 = plan.next();
  ASSERT_TRUE(on2 && on2->local);
  EXPECT_TRUE(endsWith(on2->method, "growth 2, on a wide patch")) << on2->method;
  EXPECT_EQ(on2->local->x[0], 3.0);

  tell(plan, on, 5, 4.0);  // worse again
  const std::optional<RepairStep> all = plan.next();
  ASSERT_TRUE(all);
  EXPECT_FALSE(all->local);
  EXPECT_EQ(all->method, "weighted");
  EXPECT_EQ(all->frames.faces, on.coneFaces);
}

TEST(RepairPlan, WidensWhatAPatchLeftWrongAndStartsFromIt) {
  const Prepared on = sphere(32);
  RepairPlan plan(on.mesh, on.setup, false);
  plan.next();
  tell(plan, on, 5, 1.0);
  EXPECT_TRUE(endsWith(plan.next()->method, "growth 1, locally"));
  tell(plan, on, 2, 2.0);  // better
  const std::optional<RepairStep> wide = plan.next();
  ASSERT_TRUE(wide && wide->local);
  EXPECT_TRUE(endsWith(wide->method, "growth 2, on a wide patch")) << wide->method;
  EXPECT_EQ(wide->local->x[0], 2.0);
}

TEST(RepairPlan, HasNoPatchOfALargePartOfTheMesh) {
  const Prepared on = sphere(4);
  RepairPlan plan(on.mesh, on.setup, false);
  plan.next();
  tell(plan, on, 2, 1.0);
  int steps = 0;
  for (std::optional<RepairStep> step = plan.next(); step; step = plan.next()) {
    ++steps;
    EXPECT_FALSE(step->local) << step->method;
    tell(plan, on, 2, 1.0);
  }
  EXPECT_GT(steps, 3);
}

}  // namespace
}  // namespace hgp
