// Maps whose translations are integers.  Laws: every seam has an integer translation exactly; cones lie
// on half points in tile mode and on grid points in quad mode; the map stays certified.
#include "hgp/grid/align.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hgp/mesh/vectors.h"
#include "hgp/parametrize/parametrize.h"
#include "support/shapes.h"

namespace hgp {
namespace {

const std::vector<test::Shape>& alignedShapes() {
  static const std::vector<test::Shape> list{
      test::jittered(test::icosphere(8), 0.01), test::jittered(test::pretzel(2, 4), 0.02),
      test::jittered(test::pretzel(4, 3), 0.02), test::jittered(test::torus(20, 14), 0.01),
      test::jittered(test::puncturedTorus(20, 14), 0.01)};
  return list;
}

Parametrization aligned(const TriMesh& mesh, int q, double perCone, GridMode mode) {
  SuggestOptions suggest;
  suggest.q = q;
  Result<CompleteSpec> spec = suggestCones(mesh, suggest);
  EXPECT_TRUE(spec);
  ParametrizeOptions options;
  options.grid.cells = perCone * std::max<double>(4, static_cast<double>(spec->cones.size()));
  options.grid.mode = mode;
  Result<Parametrization> run = parametrize(mesh, toSpec(*spec), options);
  EXPECT_TRUE(run);
  return run ? std::move(*run) : Parametrization();
}

void expectAligned(const test::Shape& shape, int q, double perCone, GridMode mode) {
  const TriMesh mesh = shape.mesh();
  const Parametrization run = aligned(mesh, q, perCone, mode);
  ASSERT_TRUE(run.grid) << shape.name;
  EXPECT_TRUE(run.grid->isAligned) << shape.name << ": " << run.grid->attempts.size();
  EXPECT_TRUE(run.isCertified) << shape.name;
  const ExactSeamFacts& seams = run.certificate.exactSeams;
  EXPECT_GT(seams.integer, 0) << shape.name;
  EXPECT_EQ(seams.integer, static_cast<int>(run.certificate.seams.seams.size())) << shape.name;
  for (const ConePoint& cone : run.spec.cones)
    for (std::size_t c = 0; c < run.copyOf.size(); ++c) {
      if (run.copyOf[c] != cone.vertex) continue;
      const double unit = mode == GridMode::kQuad ? 1.0 : 2.0;
      if (mode == GridMode::kTile && cone.k % q == 0) continue;  // free to lie anywhere
      for (double x : run.map.uv[c])
        EXPECT_EQ(unit * x, std::rint(unit * x)) << shape.name << " cone " << cone.vertex.i;
    }
}

TEST(AlignToGrid, TranslationsAreIntegersAndTheMapIsCertified) {
  for (const test::Shape& shape : alignedShapes())
    for (int q : {2, 4}) expectAligned(shape, q, 100, GridMode::kTile);
}

TEST(AlignToGrid, FewCellsPerConeWorkAsWell) {
  for (const test::Shape& shape : alignedShapes()) expectAligned(shape, 4, 25, GridMode::kTile);
}

TEST(AlignToGrid, InQuadModeConesAreGridPoints) {
  for (const test::Shape& shape : alignedShapes()) expectAligned(shape, 4, 100, GridMode::kQuad);
}

/// Half a cell for 24 cones, and few triangles to make room with.
test::Shape crowdedShape() { return test::pretzel(2, 3); }

TEST(AlignToGrid, WithoutAChoiceTheReasonNamesADensityThatWorks) {
  const TriMesh mesh = crowdedShape().mesh();
  const Parametrization run = aligned(mesh, 4, 0.02, GridMode::kQuad);
  ASSERT_TRUE(run.grid);
  EXPECT_FALSE(run.grid->isAligned);
  EXPECT_TRUE(run.isCertified);  // as solved
  ASSERT_TRUE(run.grid->reason);
  EXPECT_EQ(run.grid->reason->code, "grid-no-integers");
  EXPECT_FALSE(run.grid->attempts.empty());
  if (run.grid->workingCells == 0) return;
  ParametrizeOptions options;
  options.grid.mode = GridMode::kQuad;
  options.grid.cells = run.grid->workingCells;
  Result<Parametrization> again = parametrize(mesh, toSpec(run.spec), options);
  ASSERT_TRUE(again);
  EXPECT_TRUE(again->grid->isAligned) << again->grid->attempts.size();
}

/// A certified map whose grid is too coarse for its cones: every means is tried.
struct Crowded {
  TriMesh mesh = crowdedShape().mesh();
  Parametrization plain;
  std::vector<VertexId> cones;
  GridOptions options{0.02, 0.0, GridMode::kQuad};

  Crowded() {
    Result<CompleteSpec> spec = suggestCones(mesh, {});
    plain = *parametrize(mesh, toSpec(*spec), {});
    for (const ConePoint& cone : spec->cones) cones.push_back(cone.vertex);
    options.cells *= static_cast<double>(cones.size());
  }
  AlignedMap align(const Progress& progress, double work) const {
    return alignToGrid(mesh, plain.map, 4, cones, options, nullptr, progress, work);
  }
};

TEST(AlignToGrid, WithoutABudgetOnlyTheLinearStepRunsAndTheReasonSaysSo) {
  const Crowded crowded;
  const AlignedMap all = crowded.align({}, 1e300), little = crowded.align({}, 0.0);
  ASSERT_FALSE(all.map);
  ASSERT_FALSE(little.map);
  EXPECT_GT(all.report.attempts.size(), 4u);
  EXPECT_EQ(little.report.attempts.size(), 1u);
  ASSERT_TRUE(all.report.reason && little.report.reason);
  EXPECT_EQ(*all.report.reason->find("cutShort"), NoteValue("cutShort", 0));
  EXPECT_EQ(*little.report.reason->find("cutShort"), NoteValue("cutShort", 1));
  ASSERT_FALSE(little.report.closest.empty());
  for (const ConeDistance& pair : little.report.closest) {
    EXPECT_LT(pair.cells, 1.0);
    EXPECT_EQ(std::count(crowded.cones.begin(), crowded.cones.end(), pair.a), 1);
    EXPECT_EQ(std::count(crowded.cones.begin(), crowded.cones.end(), pair.b), 1);
  }
}

TEST(AlignToGrid, ContinuesWhereTheVerifierRefusesAMap) {
  // A verifier that refuses the first two maps that are handed to it: other densities follow.
  const TriMesh mesh = alignedShapes()[1].mesh();
  const Parametrization plain = *parametrize(mesh, toSpec(*suggestCones(mesh, {})), {});
  std::vector<VertexId> cones;
  for (const ConePoint& cone : plain.spec.cones) cones.push_back(cone.vertex);
  const GridOptions options{100.0 * static_cast<double>(cones.size()), 0.0, GridMode::kTile};
  const auto align = [&](const std::function<Acceptance(const UvMap&)>& accepts) {
    return alignToGrid(mesh, plain.map, 4, cones, options, nullptr, {}, 1e300, accepts);
  };
  int asked = 0;
  const AlignedMap third = align([&](const UvMap& map) {
    EXPECT_EQ(map.uv.size(), plain.map.uv.size());
    return ++asked > 2 ? Acceptance::kAccepted : Acceptance::kRefused;
  });
  ASSERT_TRUE(third.map);
  EXPECT_EQ(asked, 3);
  EXPECT_TRUE(third.report.isAligned);
  ASSERT_GE(third.report.attempts.size(), 3u);
  EXPECT_NE(third.report.attempts[0].method.find("not certified"), std::string::npos);
  EXPECT_NE(third.report.attempts.back().factor, 1.0);

  std::vector<UvMap> offered;
  const AlignedMap second = align([&](const UvMap& map) {
    offered.push_back(map);
    return offered.size() == 1 ? Acceptance::kRefused : Acceptance::kSecondChoice;
  });
  ASSERT_TRUE(second.map && second.isSecondChoice);
  ASSERT_GE(offered.size(), 3u);
  EXPECT_EQ(second.map->uv, offered[1].uv);
  EXPECT_EQ(second.report.attempts.back().factor, 1.03 * 1.03);
  EXPECT_NEAR(second.report.cells, 1.03 * 1.03 * options.cells, 0.05 * options.cells);

  const AlignedMap none = align([](const UvMap&) { return Acceptance::kRefused; });
  EXPECT_FALSE(none.map);
  EXPECT_FALSE(none.report.isAligned);
  EXPECT_TRUE(none.report.reason);
}

TEST(AlignToGrid, CancelledAtAnyPointGivesNoMap) {
  const Crowded crowded;
  int calls = 0;
  (void)crowded.align([&](const ProgressReport&) { return ++calls > 0; }, 1e300);
  ASSERT_GT(calls, 6);
  for (int last = 1; last <= calls; last += std::max(1, calls / 12)) {
    int seen = 0;
    const AlignedMap cancelled =
        crowded.align([&](const ProgressReport&) { return ++seen < last; }, 1e300);
    EXPECT_TRUE(cancelled.isCancelled) << last << " of " << calls;
    EXPECT_FALSE(cancelled.map);
    EXPECT_LE(seen, last + 1);
  }
}

TEST(AlignToGrid, OrdersWithoutSquareCellsAreRefusedWithTheReason) {
  const AlignedMap aligned =
      alignToGrid(alignedShapes()[0].mesh(), {}, 3, {}, {100.0}, nullptr, {});
  EXPECT_FALSE(aligned.map);
  EXPECT_EQ(aligned.report.reason, Note("grid-order", {{"q", 3}}));
}

/// Eight cones of 270° at the corners of a cube, and pairs of 270° and 450° that are mesh neighbours.
HolonomySpec crowdedSphere(const TriMesh& mesh) {
  const auto nearest = [&](const Vec3& p) {
    VertexId best(0);
    for (VertexId v : mesh.vertices())
      if (distance(mesh.position(v), p) < distance(mesh.position(best), p)) best = v;
    return best;
  };
  HolonomySpec spec;
  const double s = 1.0 / std::sqrt(3.0);
  for (double x : {-s, s})
    for (double y : {-s, s})
      for (double z : {-s, s}) spec.cones.push_back({nearest({x, y, z}), 3});
  for (const Vec3& p : {Vec3{1, 0.1, 0}, Vec3{-1, 0, 0.2}, Vec3{0, 1, 0.1}, Vec3{0.1, -1, 0},
                        Vec3{0, 0.2, 1}, Vec3{0.1, 0.1, -1}}) {
    const VertexId v = nearest(p);
    spec.cones.push_back({v, 3});
    spec.cones.push_back({mesh.head(mesh.outgoing(v)), 5});
  }
  return spec;
}

/// Length of an edge at `v` in cells, in a map before alignment with so many of them.
double edgeInCells(const TriMesh& mesh, const UvMap& map, VertexId v, double cells) {
  const HalfedgeId h = mesh.outgoing(v);
  double area = 0.0, length = 0.0;
  for (FaceId f : mesh.faces()) {
    const auto [i, j, k] = map.cornerUv[at(f.i)];
    const Vec2 &a = map.uv[at(i)], &b = map.uv[at(j)], &c = map.uv[at(k)];
    area += 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
    if (f == TriMesh::face(h)) {
      const Vec2* corner[] = {&a, &b, &c};
      const int n = h.i % 3;
      length = std::hypot((*corner[n])[0] - (*corner[(n + 1) % 3])[0],
                          (*corner[n])[1] - (*corner[(n + 1) % 3])[1]);
    }
  }
  return length * std::sqrt(cells / area);
}

TEST(AlignToGrid, PrescribedConesThatAreMeshNeighboursAreSpreadOverCells) {
  const TriMesh mesh = test::jittered(test::icosphere(16), 0.01).mesh();
  const HolonomySpec spec = crowdedSphere(mesh);
  for (GridMode mode : {GridMode::kTile, GridMode::kQuad}) {
    ParametrizeOptions options;
    const Result<Parametrization> plain = parametrize(mesh, spec, options);
    ASSERT_TRUE(plain && plain->isCertified);
    options.grid = {25.0 * static_cast<double>(spec.cones.size()), 0.0, mode};
    EXPECT_LT(edgeInCells(mesh, plain->map, spec.cones[8].vertex, options.grid.cells), 0.5);
    const Result<Parametrization> run = parametrize(mesh, spec, options);
    ASSERT_TRUE(run && run->grid);
    EXPECT_TRUE(run->grid->isAligned) << run->grid->attempts.size();
    EXPECT_TRUE(run->isCertified);
    EXPECT_EQ(run->certificate.exactSeams.integer,
              static_cast<int>(run->certificate.seams.seams.size()));
  }
}

}  // namespace
}  // namespace hgp
