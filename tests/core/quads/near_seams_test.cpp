// Multiple edges found along the seams.  Laws: the answer is that of counting in all quads, for any cut to a
// disk and for more edges than that; a long triangle costs what its grid points cost.
#include "hgp/quads/near_seams.h"

#include <gtest/gtest.h>

#include "hgp/grid/snap.h"
#include "hgp/parametrize/parametrize.h"
#include "hgp/quads/multiple_edges.h"
#include "support/maps.h"
#include "support/seamless.h"

namespace hgp {
namespace {

struct Tally {
  int with = 0, without = 0;
};

/// Compares the search along a cut of the surface, and along all edges, with the count in the extracted quads.
void compare(const std::string& name, const TriMesh& mesh, const UvMap& map,
             const HolonomySpec& spec, Tally& tally) {
  const Result<QuadMesh> quads = extractQuads(mesh, map, spec.q);
  if (!quads) return;
  const bool hasPairs = countMultipleEdges(*quads).pairs > 0;
  const std::optional<test::CutSurface> cut = test::cutSurface(name, mesh, spec);
  ASSERT_TRUE(cut) << name;
  EXPECT_EQ(hasMultipleEdges(mesh, map, cut->cut.isSeam), hasPairs) << name;
  EXPECT_EQ(hasMultipleEdges(mesh, map, PerEdge<char>(at(mesh.edgeCount()), 1)), hasPairs) << name;
  ++(hasPairs ? tally.with : tally.without);
}

TEST(NearSeams, FindWhatTheCountOfAllQuadsFindsOnCoarseGrids) {
  Tally tally;
  for (const test::Shape& shape :
       {test::jittered(test::icosphere(4), 0.01), test::jittered(test::pretzel(1, 3), 0.02),
        test::jittered(test::pretzel(3, 2), 0.02), test::jittered(test::torus(18, 7), 0.01),
        test::jittered(test::annulus(12, 3), 0.01),
        test::jittered(test::puncturedTorus(9, 6), 0.01)}) {
    const TriMesh mesh = shape.mesh();
    Result<CompleteSpec> spec = suggestCones(mesh, {});
    ASSERT_TRUE(spec);
    for (double perCone : {0.6, 1.0, 2.0, 3.0, 5.0, 9.0}) {
      ParametrizeOptions options;
      options.grid.cells = perCone * std::max<double>(4, static_cast<double>(spec->cones.size()));
      options.grid.mode = GridMode::kQuad;
      const Result<Parametrization> run = parametrize(mesh, toSpec(*spec), options);
      ASSERT_TRUE(run) << shape.name;
      if (!run->grid->isAligned) continue;
      std::vector<VertexId> cones;
      for (const ConePoint& cone : run->spec.cones) cones.push_back(cone.vertex);
      const std::optional<UvMap> map = snapAligned(mesh, run->map, 4, cones);
      ASSERT_TRUE(map) << shape.name;
      compare(shape.name, mesh, *map, toSpec(run->spec), tally);
    }
  }
  EXPECT_GE(tally.with, 4);
  EXPECT_GE(tally.without, 8);
}

TEST(NearSeams, FindLoopsAroundHandlesOfOneAndTwoCells) {
  const TriMesh mesh = test::torus(8, 5).mesh();
  Tally tally;
  for (const int around : {1, 2, 3}) {
    UvMap map = test::flatTorusMap(8, 5);
    for (Vec2& p : map.uv) p[0] *= around / 8.0;
    HolonomySpec spec;
    spec.q = 4;
    compare("torus of " + std::to_string(around), mesh, map, spec, tally);
  }
  EXPECT_EQ(tally.with, 2);
  EXPECT_EQ(tally.without, 1);
}

TEST(NearSeams, OrbifoldsOfTheSphereHaveFoldedQuadsAndPairs) {
  // Cones of k = 1 whose quads are folded in any grid: their pairs do not count, others do.
  const TriMesh mesh = test::icosphere(4).mesh();
  Tally tally;
  for (const double cells : {4.0, 8.0, 16.0, 40.0}) {
    HolonomySpec spec;
    spec.q = 4;
    for (const int v : {0, 3, 9}) spec.cones.push_back({VertexId(v), v == 0 ? 2 : 1});
    ParametrizeOptions options;
    options.grid.cells = cells;
    options.grid.mode = GridMode::kQuad;
    const Result<Parametrization> run = parametrize(mesh, spec, options);
    ASSERT_TRUE(run) << run.error().message;
    if (run->grid->isAligned) compare("orbifold", mesh, run->map, spec, tally);
  }
  EXPECT_GE(tally.with + tally.without, 2);
}

TEST(NearSeams, ManyCellsInFewTrianglesAreExtractedAndSearched) {
  // Triangles that are long across the grid: each has 450 grid points, its box 1.5 · 10⁵.
  const TriMesh mesh = test::torus(3, 3).mesh();
  UvMap map = test::flatTorusMap(3, 3);
  for (Vec2& p : map.uv) p = {30 * p[0], 30 * p[1] + 160 * 30 * p[0]};
  const Result<QuadMesh> quads = extractQuads(mesh, map, 4);
  ASSERT_TRUE(quads) << quads.error().message;
  EXPECT_EQ(quads->quads.size(), 90u * 90u);
  EXPECT_FALSE(hasMultipleEdges(mesh, map, PerEdge<char>(at(mesh.edgeCount()), 1)));
}

}  // namespace
}  // namespace hgp
