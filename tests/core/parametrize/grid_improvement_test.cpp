// A descent after alignment.  Laws: integers and cones stay where alignment put them, to the last bit; the map
// stays certified; the energy that was asked for falls.
#include <gtest/gtest.h>

#include <cmath>

#include "hgp/grid/align.h"
#include "hgp/parametrize/after/solution.h"
#include "hgp/parametrize/parametrize.h"
#include "hgp/seams/seam_structure.h"
#include "support/shapes.h"

namespace hgp {
namespace {

struct AskedOfGrid {
  int q = 4;
  GridMode mode = GridMode::kTile;
  double balance = 0.0;
  double perCone = 20.0;
};

std::vector<test::Shape> alignedSurfaces() {
  return {test::jittered(test::icosphere(8), 0.01), test::jittered(test::pretzel(2, 4), 0.02),
          test::jittered(test::torus(20, 14), 0.01),
          test::jittered(test::puncturedTorus(20, 14), 0.01)};
}

HolonomySpec automaticCones(const TriMesh& mesh, int q) {
  SuggestOptions suggest;
  suggest.q = q;
  const Result<CompleteSpec> spec = suggestCones(mesh, suggest);
  EXPECT_TRUE(spec);
  return spec ? toSpec(*spec) : HolonomySpec();
}

ParametrizeOptions optionsOf(const AskedOfGrid& asked, const HolonomySpec& spec, bool hasGrid) {
  ParametrizeOptions options;
  options.improve.emplace().balance = asked.balance;
  if (!hasGrid) return options;
  options.grid.cells =
      asked.perCone * std::max<double>(4.0, static_cast<double>(spec.cones.size()));
  options.grid.mode = asked.mode;
  return options;
}

std::vector<VertexId> conesOf(const Parametrization& run) {
  std::vector<VertexId> cones;
  for (const ConePoint& cone : run.spec.cones) cones.push_back(cone.vertex);
  return cones;
}

/// Copies of cones that are at a fixed place, and translations of seams.
std::vector<Complex> integersOf(const TriMesh& mesh, const UvMap& map, int q, GridMode mode,
                                const std::vector<ConePoint>& points) {
  std::vector<VertexId> cones;
  for (const ConePoint& point : points) cones.push_back(point.vertex);
  const std::optional<SeamStructure> seams = readSeams(mesh, map, q, cones);
  EXPECT_TRUE(seams);
  std::vector<Complex> values = chainTranslations(*seams, mesh, map.uv);
  for (const ConePoint& point : points) {
    if (mode == GridMode::kTile && point.k % q == 0) continue;  // free to lie anywhere
    const Vec2& p = map.uv[at(seams->firstCopy[point.vertex])];
    values.emplace_back(p[0], p[1]);
  }
  return values;
}

/// The same in two steps: a run without a grid, aligned by itself at the same cost.
UvMap alignedAlone(const TriMesh& mesh, const HolonomySpec& spec, const AskedOfGrid& asked) {
  const Result<Parametrization> run = parametrize(mesh, spec, optionsOf(asked, spec, false));
  EXPECT_TRUE(run && run->isCertified);
  const AlignedMap aligned =
      alignToGrid(mesh, run->map, spec.q, conesOf(*run), optionsOf(asked, spec, true).grid, nullptr,
                  {}, alignmentMultiplyAdds(mesh, *run));
  EXPECT_TRUE(aligned.map);
  return aligned.map.value_or(UvMap());
}

double energyOf(const DistortionFacts& facts, double balance) {
  return balance < 0.0 ? facts.meanMu : facts.symmetricDirichlet;
}

void expectHeld(const std::string& name, const TriMesh& mesh, const HolonomySpec& spec,
                const AskedOfGrid& asked, const Parametrization& run) {
  EXPECT_TRUE(run.isCertified) << name;
  EXPECT_EQ(run.certificate.exactSeams.integer,
            static_cast<int>(run.certificate.seams.seams.size()))
      << name;
  const std::vector<Complex> now = integersOf(mesh, run.map, spec.q, asked.mode, run.spec.cones);
  EXPECT_EQ(now,
            integersOf(mesh, alignedAlone(mesh, spec, asked), spec.q, asked.mode, run.spec.cones))
      << name;
}

TEST(GridImprovement, GainsWhileEveryIntegerStaysWhereAlignmentPutIt) {
  int gained = 0, runs = 0;
  for (const test::Shape& shape : alignedSurfaces()) {
    const TriMesh mesh = shape.mesh();
    for (const AskedOfGrid& asked :
         {AskedOfGrid{4, GridMode::kTile, 0.0}, AskedOfGrid{4, GridMode::kQuad, 0.0},
          AskedOfGrid{2, GridMode::kTile, 0.0}, AskedOfGrid{4, GridMode::kTile, -1.0}}) {
      const HolonomySpec spec = automaticCones(mesh, asked.q);
      const Result<Parametrization> run = parametrize(mesh, spec, optionsOf(asked, spec, true));
      ASSERT_TRUE(run && run->grid && run->improvement) << shape.name;
      ASSERT_TRUE(run->grid->isAligned) << shape.name << ": " << run->grid->attempts.size();
      ASSERT_TRUE(run->improvement->onGrid) << shape.name;
      const DescentFacts& descent = *run->improvement->onGrid;
      expectHeld(shape.name, mesh, spec, asked, *run);
      EXPECT_DOUBLE_EQ(descent.after.symmetricDirichlet,
                       run->certificate.distortion.symmetricDirichlet);
      if (asked.balance == 0.0) {
        EXPECT_LE(descent.after.symmetricDirichlet, descent.before.symmetricDirichlet);
      }
      if (descent.outcome == DescentOutcome::kNothingToGain) continue;
      ++runs;
      gained += descent.isKept &&
                energyOf(descent.after, asked.balance) < energyOf(descent.before, asked.balance);
    }
  }
  EXPECT_GE(runs, 12);
  EXPECT_GE(4 * gained, 3 * runs) << "of " << runs;
}

TEST(GridImprovement, RegainsAFifthOfWhatAlignmentGaveBack) {
  // What the integers themselves cost cannot be regained. Coarse grids, where alignment gives back much.
  double before = 0.0, aligned = 0.0, after = 0.0;
  for (const test::Shape& shape : {test::jittered(test::pretzel(2, 4), 0.02),
                                   test::jittered(test::puncturedTorus(20, 14), 0.01)}) {
    const TriMesh mesh = shape.mesh();
    const HolonomySpec spec = automaticCones(mesh, 4);
    const AskedOfGrid asked{4, GridMode::kQuad, 0.0, 12.0};
    const Result<Parametrization> run = parametrize(mesh, spec, optionsOf(asked, spec, true));
    ASSERT_TRUE(run && run->improvement && run->improvement->onGrid) << shape.name;
    before += run->improvement->after.symmetricDirichlet;
    aligned += run->improvement->onGrid->before.symmetricDirichlet;
    after += run->improvement->onGrid->after.symmetricDirichlet;
  }
  EXPECT_GT(aligned, before);
  EXPECT_LT(after - before, 0.8 * (aligned - before));
}

TEST(GridImprovement, HoldsConesWithoutRotationInQuadMode) {
  // Two cones of two full turns on a surface of genus 2: their place is no sum of translations.
  const TriMesh mesh = test::jittered(test::pretzel(2, 4), 0.02).mesh();
  HolonomySpec spec;
  spec.q = 4;
  spec.cones = {{VertexId(0), 8}, {VertexId(mesh.vertexCount() - 1), 8}};
  const AskedOfGrid asked{4, GridMode::kQuad, 0.0, 40.0};
  const Result<Parametrization> run = parametrize(mesh, spec, optionsOf(asked, spec, true));
  ASSERT_TRUE(run && run->isCertified && run->grid);
  ASSERT_TRUE(run->grid->isAligned) << run->grid->attempts.size();
  ASSERT_TRUE(run->improvement && run->improvement->onGrid);
  EXPECT_TRUE(run->improvement->onGrid->isKept);
  expectHeld("two full turns", mesh, spec, asked, *run);
  const auto isCone = [&](VertexId v) {
    return v == spec.cones[0].vertex || v == spec.cones[1].vertex;
  };
  for (std::size_t c = 0; c < run->copyOf.size(); ++c)
    for (const double x : run->map.uv[c])
      if (isCone(run->copyOf[c])) {
        EXPECT_EQ(x, std::rint(x));
      }
}

TEST(GridImprovement, CanBeCancelledInEveryStep) {
  const TriMesh mesh = alignedSurfaces()[1].mesh();
  const HolonomySpec spec = automaticCones(mesh, 4);
  ParametrizeOptions options = optionsOf({4, GridMode::kQuad, 0.0, 8.0}, spec, true);
  int steps = 0;
  double last = 0.0;
  const auto isDescent = [](const ProgressReport& r) {
    return r.stage == Stage::kAlign && r.iteration >= 0;
  };
  options.progress = [&](const ProgressReport& r) {
    steps += isDescent(r);
    if (r.stage == Stage::kAlign) {
      EXPECT_GE(r.fraction, last);
      last = r.fraction;
    }
    return true;
  };
  ASSERT_TRUE(parametrize(mesh, spec, options));
  ASSERT_GT(steps, 1);
  for (int stop = 1; stop <= steps; ++stop) {
    int seen = 0;
    options.progress = [&](const ProgressReport& r) { return !isDescent(r) || ++seen < stop; };
    const Result<Parametrization> run = parametrize(mesh, spec, options);
    ASSERT_FALSE(run);
    EXPECT_EQ(run.error().code, ErrorCode::kCancelled);
  }
}

TEST(GridImprovement, IsNotDoneWhereNothingWasAlignedOrNothingIsAsked) {
  // Half a cell for 24 cones, and few triangles to make room with.
  const TriMesh coarse = test::jittered(test::pretzel(2, 3), 0.02).mesh();
  const HolonomySpec many = automaticCones(coarse, 4);
  const Result<Parametrization> crowded =
      parametrize(coarse, many, optionsOf({4, GridMode::kQuad, 0.0, 0.02}, many, true));
  ASSERT_TRUE(crowded && crowded->grid && crowded->improvement);
  EXPECT_FALSE(crowded->grid->isAligned);
  EXPECT_FALSE(crowded->improvement->onGrid);
  const TriMesh mesh = alignedSurfaces()[1].mesh();
  const HolonomySpec spec = automaticCones(mesh, 4);
  ParametrizeOptions options = optionsOf({4, GridMode::kTile, 0.0, 1e6}, spec, true);
  const Result<Parametrization> fine = parametrize(mesh, spec, options);
  ASSERT_TRUE(fine && fine->improvement && fine->improvement->onGrid);
  EXPECT_EQ(fine->improvement->onGrid->outcome, DescentOutcome::kNothingToGain);
  EXPECT_FALSE(fine->improvement->onGrid->isKept);
  options = optionsOf({}, spec, true);
  options.improve.reset();
  const Result<Parametrization> plain = parametrize(mesh, spec, options);
  ASSERT_TRUE(plain && plain->grid);
  EXPECT_TRUE(plain->grid->isAligned);
  EXPECT_FALSE(plain->improvement);
}

}  // namespace
}  // namespace hgp
