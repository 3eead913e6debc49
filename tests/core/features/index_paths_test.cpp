// Paths of units of index.  Laws: distances are the smallest sums of steps and of what the nodes at vertices on features
// gain and lose, as relaxing all steps until nothing changes finds them; the steps of a path lead from node to node.
#include "hgp/features/index_paths.h"

#include <gtest/gtest.h>

#include <random>

#include "hgp/features/field_along.h"
#include "hgp/features/index_flow.h"
#include "support/creases.h"

namespace hgp {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

/// A field on a cube with creases whose corners have lost or gained some units, so that its nodes are not all alike.
struct Cube {
  TriMesh mesh = test::cube(4).mesh();
  Geometry geometry = computeGeometry(mesh);
  AlignedField field = *alignedField(mesh, prepareSurface(mesh), test::creasesOf(mesh));

  explicit Cube(unsigned seed) {
    std::mt19937 random(seed);
    for (HalfedgeId h : mesh.halfedges())
      if (field.sectors.isFeature[mesh.edge(h)] && random() % 4u == 0)
        moveUnit(mesh, h, random() % 2u == 0 ? 1 : -1, field);
  }
};

/// What Σ costs changes by where sector `from` gives a unit to sector `to` of the same vertex (or takes one).
double exchangeCost(const IndexGraph& graph, int from, int to, int units) {
  const double before = graph.changeOf(from, 0) + graph.changeOf(to, 0);
  return std::max(0.0, graph.changeOf(from, -units) + graph.changeOf(to, units) - before);
}

std::vector<double> relaxed(const IndexGraph& graph, const IndexPaths::Starts& starts, int units) {
  std::vector<double> distance(at(graph.count()), kFar);
  for (const auto& [n, d] : starts) distance[at(n)] = std::min(distance[at(n)], d);
  for (bool isChanged = true; isChanged;) {
    isChanged = false;
    const auto relax = [&](int from, int to, double cost) {
      const double d = distance[at(from)] + cost;
      if (d >= distance[at(to)]) return;
      distance[at(to)] = d;
      isChanged = true;
    };
    for (int n = 0; n < graph.count(); ++n) {
      if (distance[at(n)] == kFar) continue;
      graph.forSteps(n, [&](HalfedgeId, bool, int to) { relax(n, to, kEdgeCost); });
      if (units == 0 || !graph.isSector(n) || isImpossible(graph.changeOf(n, -units))) continue;
      for (const int other : graph.sectorsAt(graph.vertexOf(n)))
        if (other != n && !isImpossible(graph.changeOf(other, units)))
          relax(n, other, kEdgeCost + exchangeCost(graph, n, other, units));
    }
  }
  return distance;
}

TEST(IndexPaths, AreTheCheapestOnes) {
  int acrossFeatures = 0;
  for (const unsigned seed : {1u, 2u, 3u, 4u}) {
    const Cube cube(seed);
    const IndexGraph graph(cube.mesh, cube.geometry, cube.field);
    const int sector = cube.mesh.vertexCount() + static_cast<int>(seed);
    int inPatch = 0;
    for (const int units : {0, 1, -1}) {
      const IndexPaths::Starts starts{{sector, 0.5}, {sector + 7, 0.0}};
      IndexPaths paths(graph);
      double last = 0.0;
      paths.search(starts, units, [&](int n, double d) {
        EXPECT_EQ(d, paths.distance(n));
        EXPECT_GE(d, last) << "nearest first";
        last = d;
        return true;
      });
      const std::vector<double> expected = relaxed(graph, starts, units);
      int reached = 0;
      for (int n = 0; n < graph.count(); ++n) {
        EXPECT_EQ(paths.isReached(n), expected[at(n)] < kFar);
        if (!paths.isReached(n)) continue;
        ++reached;
        EXPECT_NEAR(paths.distance(n), expected[at(n)], 1e-9)
            << "node " << n << ", units " << units;
      }
      if (units == 0) inPatch = reached;
      EXPECT_GT(inPatch, 10);
      acrossFeatures += reached > inPatch;
    }
  }
  EXPECT_GE(acrossFeatures, 4);
}

TEST(IndexPaths, StepsMoveAUnitBetweenItsEnds) {
  const Cube cube(5);
  const IndexGraph graph(cube.mesh, cube.geometry, cube.field);
  const int start = cube.mesh.vertexCount() + 3;
  IndexPaths paths(graph);
  paths.search(start, [](int, double) { return true; });
  int tried = 0;
  for (int end = 0; end < graph.count(); ++end)
    for (const int sign : {1, -1}) {
      if (!paths.isReached(end) || end == start) continue;
      AlignedField moved = cube.field;
      for (const auto& [h, units] : paths.stepsTo(end, sign)) moveUnit(cube.mesh, h, units, moved);
      for (int n = 0; n < graph.count(); ++n) {
        const int expected = n == start ? sign : n == end ? -sign : 0;
        EXPECT_EQ(moved.index[at(n)] - cube.field.index[at(n)], expected) << n;
      }
      ++tried;
    }
  EXPECT_GT(tried, 20);
}

}  // namespace
}  // namespace hgp
