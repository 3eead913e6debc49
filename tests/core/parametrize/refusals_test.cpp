// What is refused, cancelled or explained instead of solved.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "hgp/parametrize/parametrize.h"
#include "support/notes.h"
#include "support/prescriptions.h"
#include "support/shapes.h"

namespace hgp {
namespace {

HolonomySpec withCones(int q, std::vector<ConePoint> cones) {
  HolonomySpec spec;
  spec.q = q;
  spec.cones = std::move(cones);
  return spec;
}

void expectRefused(const TriMesh& mesh, const HolonomySpec& spec, const std::string& word) {
  const Result<Parametrization> p = parametrize(mesh, spec, {});
  ASSERT_FALSE(p) << word;
  EXPECT_EQ(p.error().code, ErrorCode::kPrescription);
  EXPECT_NE(p.error().message.find(word), std::string::npos) << p.error().message;
}

TEST(Refusals, ATorusWithOneConeOfThreeAndOneOfFiveHasNoMap) {
  const TriMesh mesh = test::torus(12, 8).mesh();
  expectRefused(mesh, withCones(4, {{VertexId(3), 3}, {VertexId(50), 5}}), "torus");
  expectRefused(mesh, withCones(6, {{VertexId(3), 5}, {VertexId(50), 7}}), "torus");
}

TEST(Refusals, GaussBonnetIsCheckedInIntegersBeforeAnythingIsSolved) {
  expectRefused(test::icosphere(3).mesh(), withCones(4, {{VertexId(0), 3}}), "Lemma 6.2");
  HolonomySpec disk = withCones(4, {{VertexId(0), 3}});
  disk.turning = {4};
  expectRefused(test::disk(4).mesh(), disk, "Lemma 6.2");
}

TEST(Refusals, AConeFreeTorusCannotRotate) {
  HolonomySpec spec;
  spec.handles = {1, 0};
  expectRefused(test::torus(12, 8).mesh(), spec, "torus");
}

TEST(Refusals, ASphereNeedsAnOrderOfTwoOrMore) {
  expectRefused(test::icosphere(2).mesh(), withCones(1, {}), "q");
}

TEST(Refusals, ConvexBoundaryNeedsADisk) {
  for (const test::Shape& shape :
       {test::icosphere(2), test::annulus(8, 3), test::puncturedTorus(6, 5)}) {
    const Result<Parametrization> p = parametrizeConvex(shape.mesh(), {});
    ASSERT_FALSE(p);
    EXPECT_EQ(p.error().code, ErrorCode::kUnsupported);
  }
}

TEST(Refusals, ZeroRoundsAreAUsageError) {
  ParametrizeOptions options;
  options.maxRounds = 0;
  const Result<Parametrization> p = parametrize(test::disk(3).mesh(), {}, options);
  ASSERT_FALSE(p);
  EXPECT_EQ(p.error().code, ErrorCode::kUsage);
}

TEST(Cancel, EndsEveryStageAtOnce) {
  const TriMesh mesh = test::icosphere(4).mesh();
  HolonomySpec spec;
  for (VertexId v : test::spreadVertices(mesh, 8)) spec.cones.push_back({v, 3});
  std::set<Stage> stages;
  ParametrizeOptions options;
  options.progress = [&](const ProgressReport& r) {
    stages.insert(r.stage);
    return true;
  };
  ASSERT_TRUE(parametrize(mesh, spec, options));
  for (const Stage stage : {Stage::kField, Stage::kCut, Stage::kAssemble, Stage::kSolve})
    EXPECT_TRUE(stages.count(stage)) << stageName(stage);
  for (const Stage stage : stages) {
    int after = 0;
    bool isOver = false;
    options.progress = [&](const ProgressReport& r) {
      if (isOver) ++after;
      isOver |= r.stage == stage;
      return !isOver;
    };
    const Result<Parametrization> p = parametrize(mesh, spec, options);
    ASSERT_FALSE(p) << stageName(stage);
    EXPECT_EQ(p.error().code, ErrorCode::kCancelled) << stageName(stage);
    EXPECT_EQ(after, 0) << stageName(stage);
  }
}

TEST(Impossible, APrescriptionThatIsProvedSoEndsAfterOneProgramWithTheProof) {
  // No cone is steep, but the rim asks for more than its triangles hold.
  const TriMesh mesh = test::annulus(8, 6).mesh();
  HolonomySpec spec;
  spec.turning = {-20, 0};
  for (VertexId v : mesh.vertices())
    if (!mesh.isBoundary(v) && spec.cones.size() < 20) spec.cones.push_back({v, 3});
  const Result<Parametrization> run = parametrize(mesh, spec, {});
  ASSERT_TRUE(run) << run.error().message;
  EXPECT_FALSE(run->isCertified);
  EXPECT_TRUE(run->isImpossible);
  EXPECT_EQ(run->rounds.size(), 1u);
  ASSERT_TRUE(findNote(run->notes, "angle-shortage"));
  EXPECT_EQ(*findNote(run->notes, "angle-shortage")->find("turning"), NoteValue("turning", "-20"));
  spec.turning = {};
  spec.cones.clear();
  const Result<Parametrization> possible = parametrize(mesh, spec, {});
  ASSERT_TRUE(possible && possible->isCertified);
  EXPECT_FALSE(possible->isImpossible);
}

TEST(Progress, StagesComeInTheirOrderAndNoneComesBack) {
  for (const test::Shape& shape : {test::icosphere(4), test::pretzel(2, 3), test::disk(4)}) {
    const TriMesh mesh = shape.mesh();
    Stage last = Stage::kPrepare;
    const Progress inOrder = [&](const ProgressReport& r) {
      EXPECT_GE(r.stage, last) << stageName(r.stage) << " after " << stageName(last);
      last = r.stage;
      return true;
    };
    SuggestOptions suggest;
    suggest.progress = inOrder;
    const Result<CompleteSpec> spec = suggestCones(mesh, suggest);
    ASSERT_TRUE(spec) << shape.name;
    last = Stage::kPrepare;
    ParametrizeOptions options;
    options.progress = inOrder;
    ASSERT_TRUE(parametrize(mesh, toSpec(*spec), options)) << shape.name;
  }
}

TEST(Progress, FractionsStayBetweenZeroAndOneAndIterationsAndRoundsCount) {
  ParametrizeOptions options;
  int last = -1, solves = 0, rounds = 0;
  options.progress = [&](const ProgressReport& r) {
    EXPECT_GE(r.fraction, 0.0);
    EXPECT_LE(r.fraction, 1.0);
    EXPECT_TRUE(r.round == rounds || (r.round == rounds + 1 && r.iteration < 0)) << r.round;
    EXPECT_EQ(r.maxRounds, r.round > 0 ? options.maxRounds : 0);
    rounds = r.round;
    if (r.stage == Stage::kSolve && r.iteration >= 0) {
      EXPECT_TRUE(r.iteration == last + 1 || r.iteration == 0);
      last = r.iteration;
      ++solves;
    }
    return true;
  };
  // Cones that strain their surface: a cone program with iterations.
  const TriMesh mesh = test::pretzel(2, 3).mesh();
  HolonomySpec spec;
  for (int v = 0; v < 8; ++v) spec.cones.push_back({VertexId(7 * v), 5});
  const Result<Parametrization> p = parametrize(mesh, spec, options);
  ASSERT_TRUE(p);
  EXPECT_GT(solves, 2);
  EXPECT_EQ(rounds, static_cast<int>(p->rounds.size()));
}

TEST(Notes, SayWhenConesStretchTheSurfaceTooFar) {
  // A long tube rolled out as an annulus: e^(length · 2π / girth) between its ends.
  const TriMesh mesh = test::cylinder(8, 40).mesh();
  HolonomySpec spec;
  spec.turning = {4, -4};
  ParametrizeOptions options;
  options.maxRounds = 1;
  const Result<Parametrization> p = parametrize(mesh, spec, options);
  ASSERT_TRUE(p) << p.error().message;
  EXPECT_TRUE(findNote(p->notes, "map-unresolved") || findNote(p->notes, "map-stretched"));
}

TEST(Notes, AMapIsLessConformalWhereTheConformalOneIsBeyondFloat64) {
  const TriMesh mesh = test::cylinder(8, 40).mesh();
  HolonomySpec spec;
  spec.turning = {4, -4};
  const Result<Parametrization> p = parametrize(mesh, spec, {});
  ASSERT_TRUE(p) << p.error().message;
  EXPECT_TRUE(p->isCertified);
  EXPECT_TRUE(p->isUsable);
  // Weighted with e^u as it is, it takes thirteen.
  EXPECT_LE(p->rounds.size(), 6U);
  // Stretched it is, and that is all that is said: nothing of maps that cannot be.
  EXPECT_EQ(test::codesOf(p->notes), test::Codes{"map-stretched"});
}

}  // namespace
}  // namespace hgp
