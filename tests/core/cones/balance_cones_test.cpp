#include "hgp/cones/balance_cones.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "hgp/cones/choose_cones.h"
#include "hgp/cones/cone_metric.h"
#include "hgp/field/prepared_surface.h"
#include "support/shapes.h"

namespace hgp {
namespace {

long long unitsOf(const HolonomySpec& spec) {
  long long units = 0;
  for (const ConePoint& cone : spec.cones) units += spec.q - cone.k;
  for (const auto& l : spec.turning) units += l.value_or(0);
  return units;
}

bool keeps(const HolonomySpec& made, const HolonomySpec& given) {
  return std::all_of(given.cones.begin(), given.cones.end(), [&](const ConePoint& cone) {
    return std::any_of(made.cones.begin(), made.cones.end(), [&](const ConePoint& one) {
      return one.vertex == cone.vertex && one.k == cone.k;
    });
  });
}

HolonomySpec specOf(int q, std::vector<ConePoint> cones) {
  HolonomySpec spec;
  spec.q = q;
  spec.cones = std::move(cones);
  return spec;
}

TEST(BalanceCones, CompleteAnyConesToExactlyGaussBonnetAndKeepThem) {
  const TriMesh mesh = test::jittered(test::icosphere(6), 0.1).mesh();
  for (const int q : {2, 3, 4, 6, 8}) {
    for (const int first : {q - 1, q + 1}) {
      PreparedSurface surface(mesh);
      const HolonomySpec given = specOf(q, {{VertexId{5}, first}, {VertexId{100}, q - 1}});
      const auto made = balanceCones(surface, given);
      ASSERT_TRUE(made) << q << " " << made.error().message;
      EXPECT_EQ(unitsOf(*made), 2 * q);
      EXPECT_TRUE(keeps(*made, given));
      EXPECT_TRUE(checkPrescription(mesh, surface.topology(), *made));
      std::set<int> vertices;
      for (const ConePoint& cone : made->cones) vertices.insert(cone.vertex.i);
      EXPECT_EQ(vertices.size(), made->cones.size());
    }
  }
}

TEST(BalanceCones, NewConesShareNoTriangleWithGivenOnesWhereThereIsRoom) {
  const TriMesh mesh = test::icosphere(6).mesh();
  PreparedSurface surface(mesh);
  const HolonomySpec given = specOf(4, {{VertexId{5}, 3}, {VertexId{200}, 5}});
  const auto made = balanceCones(surface, given);
  ASSERT_TRUE(made);
  for (const ConePoint& cone : made->cones)
    for (const ConePoint& one : given.cones)
      for (const HalfedgeId h : outgoingHalfedges(mesh, one.vertex))
        EXPECT_NE(mesh.head(h), cone.vertex);
}

TEST(BalanceCones, NoTwoNewConesAreSideBySideWhereThereIsRoom) {
  for (const unsigned seed : {1U, 2U, 3U, 4U}) {
    const TriMesh mesh = test::jittered(test::icosphere(6), 0.3, seed).mesh();
    PreparedSurface surface(mesh);
    // Each of the given cones draws new ones of the other sign close to it.
    const HolonomySpec given = specOf(8, {{VertexId{60}, 15}, {VertexId{200}, 15}});
    const auto made = balanceCones(surface, given);
    ASSERT_TRUE(made) << made.error().message;
    EXPECT_EQ(unitsOf(*made), 16);
    std::set<int> added;
    for (const ConePoint& cone : made->cones) added.insert(cone.vertex.i);
    for (const ConePoint& cone : given.cones) added.erase(cone.vertex.i);
    for (const int v : added)
      for (const HalfedgeId h : outgoingHalfedges(mesh, VertexId{v}))
        EXPECT_EQ(added.count(mesh.head(h).i), 0U) << seed << ": " << v;
  }
}

TEST(BalanceCones, AreAddedWhereTheyLowerTheDistortion) {
  // The eight corners of a cube: all curvature is there.
  const TriMesh mesh = test::cube(6).mesh();
  PreparedSurface surface(mesh);
  const auto made = balanceCones(surface, specOf(4, {}));
  ASSERT_TRUE(made);
  ASSERT_EQ(made->cones.size(), 8U);
  for (const ConePoint& cone : made->cones) {
    EXPECT_EQ(cone.k, 3);
    EXPECT_GT(curvature(mesh, surface.context().geometry, cone.vertex), 1.0);
  }
}

double energyOf(PreparedSurface& surface, const HolonomySpec& spec) {
  const FilledSurface& filled = surface.context().surface;
  NodeDefects defects(static_cast<std::size_t>(filled.nodeCount), 0);
  for (const ConePoint& cone : spec.cones)
    defects[static_cast<std::size_t>(filled.node[cone.vertex])] = spec.q - cone.k;
  return ConeMetric(surface.mesh(), surface.context(), spec.q).cost(defects).energy;
}

/// A ball with six long arms.
test::Shape withArms() {
  test::Shape shape = test::jittered(test::icosphere(8), 0.2);
  shape.name += "-arms";
  for (auto& p : shape.data.positions) {
    const double largest = std::max({std::fabs(p[0]), std::fabs(p[1]), std::fabs(p[2])});
    const double along = largest / std::hypot(p[0], p[1], p[2]);
    for (double& x : p) x *= 1.0 + 4.0 * std::exp(40.0 * (along - 1.0));
  }
  return shape;
}

TEST(BalanceCones, WithoutGivenOnesAreNoWorseThanAsManySuggestedOnes) {
  // One by one, cones are soon stacked on the few vertices that have room for several.
  for (const test::Shape& shape : {test::jittered(test::icosphere(6), 0.3, 3), withArms(),
                                   test::cube(5), test::doubleTorus(4)}) {
    const TriMesh mesh = shape.mesh();
    PreparedSurface surface(mesh);
    const auto made = balanceCones(surface, specOf(4, {}));
    ASSERT_TRUE(made) << shape.name << ": " << made.error().message;
    SuggestOptions asMany;
    asMany.coneCount = static_cast<int>(made->cones.size());
    const auto suggested = chooseCones(surface, asMany);
    ASSERT_TRUE(suggested) << shape.name;
    EXPECT_LE(made->cones.size(), suggested->cones.size()) << shape.name;
    // What taking neighbours apart costs is allowed.
    EXPECT_LE(energyOf(surface, *made), 1.02 * energyOf(surface, *suggested) + 1e-9) << shape.name;
  }
}

TEST(BalanceCones, AComponentOfFewVerticesGetsStrongerCones) {
  const TriMesh mesh = test::tetrahedron().mesh();
  PreparedSurface surface(mesh);
  const auto made = balanceCones(surface, specOf(4, {}));
  ASSERT_TRUE(made) << made.error().message;
  EXPECT_EQ(unitsOf(*made), 8);
}

TEST(BalanceCones, NothingIsAddedToABalanceOrWhereALoopTakesTheRest) {
  const TriMesh torus = test::torus(12, 16).mesh();
  PreparedSurface closed(torus);
  HolonomySpec flat = specOf(4, {});
  flat.handles.resize(2);
  const auto none = balanceCones(closed, flat);
  ASSERT_TRUE(none);
  EXPECT_TRUE(none->cones.empty());
  const TriMesh open = test::puncturedTorus(12, 9).mesh();
  PreparedSurface rim(open);
  HolonomySpec spec = specOf(4, {});
  spec.turning.resize(1);
  spec.handles.resize(2);
  const auto kept = balanceCones(rim, spec);
  ASSERT_TRUE(kept);
  EXPECT_TRUE(kept->cones.empty());
  spec.turning[0] = 3;  // 7 units too many
  const auto made = balanceCones(rim, spec);
  ASSERT_TRUE(made) << made.error().message;
  EXPECT_EQ(unitsOf(*made), -4);
  EXPECT_EQ(made->turning[0], 3);
}

TEST(BalanceCones, WhatCannotBeIsRefusedWithItsReason) {
  const TriMesh mesh = test::tetrahedron().mesh();
  PreparedSurface surface(mesh);
  const auto strong =
      balanceCones(surface, specOf(4, {{VertexId{0}, 5}, {VertexId{1}, 5}, {VertexId{2}, 5}}));
  ASSERT_FALSE(strong);
  EXPECT_EQ(strong.error().code, ErrorCode::kPrescription);
  EXPECT_NE(strong.error().message.find("11"), std::string::npos) << strong.error().message;
  for (const ConePoint wrong : {ConePoint{VertexId{0}, 0}, ConePoint{VertexId{9}, 3}}) {
    const auto none = balanceCones(surface, specOf(4, {wrong}));
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, ErrorCode::kPrescription);
  }
}

TEST(ConesFor, ChoicesBetweenTwoHaveANumberBetweenTheirs) {
  const TriMesh mesh = test::jittered(test::icosphere(8), 0.2).mesh();
  const auto count = [&](ConesFor choice) {
    PreparedSurface surface(mesh);
    SuggestOptions options;
    options.conesFor = choice;
    const auto spec = chooseCones(surface, options);
    EXPECT_TRUE(spec);
    return spec ? static_cast<int>(spec->cones.size()) : 0;
  };
  const int few = count(ConesFor::kFew), balanced = count(ConesFor::kBalanced),
            many = count(ConesFor::kLowDistortion);
  const int fewer = count(ConesFor::kFewer), more = count(ConesFor::kMore);
  EXPECT_LE(std::abs(2 * fewer - few - balanced), 2) << few << " " << fewer << " " << balanced;
  EXPECT_LE(std::abs(2 * more - many - balanced), 2) << balanced << " " << more << " " << many;
  for (const ConesFor choice : {ConesFor::kBalanced, ConesFor::kFew, ConesFor::kLowDistortion,
                                ConesFor::kFewer, ConesFor::kMore})
    EXPECT_EQ(conesForNamed(conesForName(choice)), choice);
}

}  // namespace
}  // namespace hgp
