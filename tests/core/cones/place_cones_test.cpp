#include "hgp/cones/place_cones.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "hgp/cones/choose_cones.h"
#include "hgp/cones/cone_distances.h"
#include "hgp/field/prepared_surface.h"
#include "support/shapes.h"

namespace hgp {
namespace {

struct Placed {
  explicit Placed(const TriMesh& m) : mesh(m), surface(m) {
    EXPECT_TRUE(surface.requireConnection());
  }
  const TriMesh& mesh;
  PreparedSurface surface;
};

NodeDefects zero(const ConeMetric& metric) {
  return NodeDefects(static_cast<std::size_t>(metric.nodeCount()), 0);
}

TEST(ConeMetric, ScaleAndTwistFollowFromTheConesAlone) {
  const TriMesh mesh = test::jittered(test::pretzel(2, 4), 0.1).mesh();
  Placed p(mesh);
  const ConeMetric metric(mesh, p.surface.context(), 4);
  NodeDefects d = zero(metric);
  d[10] = -3, d[50] = -5;
  const ConeCost before = metric.cost(d);
  // A unit more at a node is what response() says, in u and along every generator.
  const int node = 77;
  d[node] += 1;
  const ConeCost after = metric.cost(d);
  EXPECT_LT((before.u + metric.response({node}) - after.u).norm(), 1e-9 * after.u.norm());
  const Eigen::VectorXd natural = before.natural + metric.naturalResponse(node);
  EXPECT_LT((natural - after.natural).norm(), 1e-9);
  EXPECT_NEAR(after.u.dot(metric.area()), 0.0, 1e-9);
}

TEST(ConeMetric, TurnAlongGeneratorsIsThatOfThePrescribedField) {
  // The connection that prescribedField() rounds has the turn that ConeMetric predicts: what is left
  // over 2π/q multiples is the twist.
  const TriMesh mesh = test::jittered(test::pretzel(2, 4), 0.1).mesh();
  Placed p(mesh);
  const auto spec = chooseCones(p.surface, {});
  ASSERT_TRUE(spec);
  const auto field = p.surface.field(*spec);
  ASSERT_TRUE(field);
  const ConeMetric metric(mesh, p.surface.context(), 4);
  NodeDefects d = zero(metric);
  for (const ConePoint& c : spec->cones)
    d[static_cast<std::size_t>(p.surface.context().surface.node[c.vertex])] = 4 - c.k;
  const ConeCost cost = metric.cost(d);
  const Eigen::VectorXd turned = cost.natural + p.surface.context().handles.periods * cost.twist;
  for (Eigen::Index j = 0; j < turned.size(); ++j) {
    const int r = field->spec.handles[static_cast<std::size_t>(j)];
    EXPECT_NEAR(principalAngle(turned[j] - turnAngle(r, 4)), 0.0, 1e-6) << j;
  }
}

TEST(ConeMetric, SlopeIsThatOfTheEnergy) {
  const TriMesh mesh = test::jittered(test::torus(14, 18), 0.05).mesh();
  Placed p(mesh);
  const ConeMetric metric(mesh, p.surface.context(), 4);
  NodeDefects d = zero(metric);
  d[10] = 1, d[90] = -1, d[33] = 1, d[150] = -1;
  const ConeCost cost = metric.cost(d);
  const ConeSlope slope = metric.slope(cost);
  PerEdge<char> isCrossed(static_cast<std::size_t>(mesh.edgeCount()), 0);
  for (const DualLoop& loop : p.surface.context().handles.loops)
    for (HalfedgeId h : loop.crossed) isCrossed[mesh.edge(h)] = 1;
  const double step = 1e-4;
  for (EdgeId e : mesh.edges()) {
    if (e.i % 7 != 0 || isCrossed[e]) continue;
    const HalfedgeId h = e.i % 2 == 0 || mesh.isBoundary(mesh.halfedge(e))
                             ? mesh.halfedge(e)
                             : mesh.twin(mesh.halfedge(e));
    const int from = mesh.tail(h).i, to = mesh.head(h).i;
    ConeCost moved = cost;
    moved.u += step * (metric.response({to}) - metric.response({from}));
    moved.natural += step * (metric.naturalResponse(to) - metric.naturalResponse(from));
    metric.measure(moved);
    const double change = slope.along(mesh, h, from, to);
    EXPECT_NEAR((moved.energy - cost.energy) / step, change, 1e-3 * (1.0 + std::abs(change)));
  }
}

TEST(ConeMetric, SlopeOfTheTwistIsClosedAlsoWhereGeneratorsCross) {
  const TriMesh mesh = test::jittered(test::pretzel(2, 4), 0.1).mesh();
  Placed p(mesh);
  const ConeMetric metric(mesh, p.surface.context(), 4);
  NodeDefects d = zero(metric);
  d[10] = 1, d[90] = -1, d[33] = -3, d[150] = -5;
  const ConeCost cost = metric.cost(d);
  ASSERT_GT(cost.twist.norm(), 1e-3);
  const ConeSlope slope = metric.slope(cost);
  double largest = 0.0;
  for (double x : slope.twist) largest = std::max(largest, std::abs(x));
  ASSERT_GT(largest, 0.0);
  for (FaceId f : mesh.faces()) {
    double sum = 0.0;
    for (int k = 0; k < 3; ++k) {
      const HalfedgeId h = TriMesh::halfedge(f, k);
      sum += slope.along(mesh, h, mesh.tail(h).i, mesh.head(h).i);
    }
    EXPECT_NEAR(sum, 0.0, 1e-9 * largest);
  }
}

TEST(PlaceCones, MeetsTheCountAndGaussBonnet) {
  for (const test::Shape& shape :
       {test::jittered(test::icosphere(6), 0.02), test::jittered(test::pretzel(2, 4), 0.1),
        test::jittered(test::disk(12), 0.1)}) {
    const TriMesh mesh = shape.mesh();
    for (int q : {2, 4, 5}) {
      Placed p(mesh);
      SuggestOptions options;
      options.q = q;
      for (int count : {12, 17}) {
        options.coneCount = count;
        const auto spec = chooseCones(p.surface, options);
        ASSERT_TRUE(spec) << shape.name << spec.error().message;
        // q = 2: a cone of k = 4 would turn frames too sharply, so that numbers may have to be even.
        EXPECT_NEAR(static_cast<double>(spec->cones.size()), count, q == 2 ? 1 : 0) << shape.name;
        EXPECT_TRUE(checkPrescription(mesh, p.surface.topology(), *spec));
      }
    }
  }
}

TEST(PlaceCones, ConesMoveToWhereTheyCostLess) {
  const TriMesh mesh = test::jittered(test::icosphere(10), 0.02).mesh();
  Placed p(mesh);
  const ConeMetric metric(mesh, p.surface.context(), 4);
  // Eight cones in one corner of the sphere.
  NodeDefects start = zero(metric);
  for (int n = 0, v = 0; n < 8; v += 7)
    if (std::abs(mesh.position(VertexId(v))[0] - 0.8) < 0.3)
      start[static_cast<std::size_t>(v)] = 1, ++n;
  const NodeDefects end = placeCones(mesh, metric, start, {});
  EXPECT_EQ(std::accumulate(end.begin(), end.end(), 0), metric.total());
  EXPECT_LT(metric.cost(end).scale, 0.1 * metric.cost(start).scale);
  // A cube's corners have σ of log₂ area .31 on the sphere.
  EXPECT_LT(areaSpread(metric.cost(end).scale), 0.4);
}

TEST(PlaceCones, ConesThatAreTooCloseInTheirOwnMetricAreMergedOrMoved) {
  const TriMesh mesh = test::jittered(test::icosphere(12), 0.02).mesh();
  Placed p(mesh);
  const ConeMetric metric(mesh, p.surface.context(), 4);
  // The eight corners of a cube, and on top of them opposite pairs of neighbours.
  PlaceOptions options;
  NodeDefects start = placeCones(mesh, metric, zero(metric), options);
  for (int v : {40, 200, 380}) {
    const int w = mesh.head(mesh.outgoing(VertexId(v))).i;
    if (start[static_cast<std::size_t>(v)] != 0 || start[static_cast<std::size_t>(w)] != 0)
      continue;
    start[static_cast<std::size_t>(v)] = 1;
    start[static_cast<std::size_t>(w)] = -1;
  }
  const auto closer = [&](const NodeDefects& d, double least) {
    return ConeDistances(mesh, metric, metric.cost(d).u).closer(d, least).size();
  };
  const double least = 0.5;  // of a sphere of radius 1
  ASSERT_GE(closer(start, least), 2u);
  options.isFixed = true;  // nothing but what the distance asks
  options.spacing = {least, 0.1};
  const NodeDefects end = placeCones(mesh, metric, start, options);
  EXPECT_EQ(closer(end, least), 0u);
  EXPECT_EQ(std::accumulate(end.begin(), end.end(), 0), metric.total());
  EXPECT_LE(metric.cost(end).energy, 1.2 * metric.cost(start).energy);
}

TEST(PlaceCones, ConesForQuadsHaveKOfAtLeastTwo) {
  const TriMesh mesh = test::jittered(test::icosphere(12), 0.02).mesh();
  Placed p(mesh);
  const ConeMetric metric(mesh, p.surface.context(), 4);
  NodeDefects start = zero(metric);
  start[40] = 3;
  start[200] = 3;
  start[380] = 2;
  PlaceOptions options;
  options.isFixed = true;
  const auto largest = [](const NodeDefects& d) { return *std::max_element(d.begin(), d.end()); };
  EXPECT_EQ(largest(placeCones(mesh, metric, start, options)), 3);
  options.spacing = {0.01, 0.1, 2};
  const NodeDefects end = placeCones(mesh, metric, start, options);
  EXPECT_EQ(largest(end), 2);
  EXPECT_EQ(std::accumulate(end.begin(), end.end(), 0), metric.total());
}

TEST(ConeDistances, AreLengthsInTheConeMetricAtTheSurfacesArea) {
  const TriMesh mesh = test::torus(24, 24).mesh();
  Placed p(mesh);
  const ConeMetric metric(mesh, p.surface.context(), 4);
  NodeDefects d = zero(metric);
  d[0] = 1, d[1] = -1;
  ConeDistances flat(mesh, metric, Eigen::VectorXd::Zero(metric.nodeCount()));
  const auto pairs = flat.closer(d, 1e9);
  ASSERT_EQ(pairs.size(), 1u);
  const Vec3 &a = mesh.position(VertexId(0)), &b = mesh.position(VertexId(1));
  EXPECT_NEAR(pairs[0].distance, std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), 1e-9);
  // e^u twice as large everywhere changes nothing, as the area stays what it is.
  ConeDistances twice(mesh, metric, Eigen::VectorXd::Constant(metric.nodeCount(), std::log(2.0)));
  EXPECT_NEAR(twice.closer(d, 1e9)[0].distance, pairs[0].distance, 1e-9);
}

TEST(PlaceCones, ConesThatAreLeftMoveAfterARemoval) {
  const TriMesh mesh = test::jittered(test::icosphere(10), 0.02).mesh();
  Placed p(mesh);
  const ConeMetric metric(mesh, p.surface.context(), 4);
  NodeDefects start = zero(metric);
  for (int n = 0; n < 48; ++n) start[static_cast<std::size_t>(19 * n)] = n < 28 ? 1 : -1;
  PlaceOptions few;
  few.spread = 1.0;
  few.nodeSolves = 80.0 * metric.nodeCount();
  const NodeDefects moved = placeCones(mesh, metric, start, few);
  EXPECT_LE(areaSpread(metric.cost(moved).scale), 1.0);
  EXPECT_LE(coneCount(mesh, p.surface.context(), moved), 4);
}

TEST(ChooseCones, RoundShapesGetFewCones) {
  const TriMesh sphere = test::jittered(test::icosphere(12), 0.01).mesh();
  Placed p(sphere);
  const auto balanced = chooseCones(p.surface, {});
  ASSERT_TRUE(balanced);
  EXPECT_LE(balanced->cones.size(), 8u);
  SuggestOptions few;
  few.conesFor = ConesFor::kFew;
  const auto fewest = chooseCones(p.surface, few);
  ASSERT_TRUE(fewest);
  EXPECT_LE(fewest->cones.size(), 4u);
  EXPECT_GE(fewest->cones.size(), 3u);
}

TEST(ChooseCones, AreLegalForEveryOrder) {
  for (const test::Shape& shape :
       {test::jittered(test::disk(10), 0.1), test::annulus(24, 8), test::puncturedTorus(14, 18),
        test::pretzel(2, 5), test::icosphere(5), test::torus(14, 18)}) {
    const TriMesh mesh = shape.mesh();
    const Topology topology = computeTopology(mesh);
    for (int q : {1, 2, 3, 4, 5, 6, 8}) {
      Placed p(mesh);
      SuggestOptions options;
      options.q = q;
      const auto spec = chooseCones(p.surface, options);
      if (q == 1 && topology.genus == 0 && topology.loops.empty()) {
        ASSERT_FALSE(spec);
        EXPECT_NE(spec.error().message.find("no map with q = 1"), std::string::npos);
        EXPECT_TRUE(spec.error().where.empty());
        continue;
      }
      ASSERT_TRUE(spec) << shape.name << " q = " << q << ": " << spec.error().message;
      EXPECT_TRUE(checkPrescription(mesh, topology, *spec)) << shape.name << " q = " << q;
    }
  }
}

}  // namespace
}  // namespace hgp
