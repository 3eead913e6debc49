#include "hgp/parametrize/strategy/moves/moves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hgp/parametrize/strategy/attempt.h"
#include "hgp/parametrize/strategy/frames_of_metric.h"
#include "support/prescriptions.h"
#include "support/shapes.h"

namespace hgp {
namespace {

using AttemptPtr = std::shared_ptr<const Attempt>;

/// A sphere with cones of the given indices far from each other, ready to be solved. `mesh` is
/// referred to by `problem`.
struct Posed {
  std::unique_ptr<TriMesh> mesh;
  ParametrizeOptions options;
  std::unique_ptr<Problem> problem;
  std::size_t indexOf(const char* weighting) const {
    for (std::size_t i = 0; i < problem->weightings.size(); ++i)
      if (std::string(problem->weightings[i].name) == weighting) return i;
    ADD_FAILURE() << "no weighting " << weighting;
    return 0;
  }
  State hardState() const { return startOf(*problem, indexOf("hard constraints")); }
  State softState() const { return startOf(*problem, indexOf("soft constraints, exact rows")); }
  State harmonicState() const { return startOf(*problem, indexOf("harmonic")); }
};

Posed sphere(int n, const std::vector<int>& indices = std::vector<int>(8, 3),
             Method method = Method::kAuto) {
  Posed out;
  out.mesh = std::make_unique<TriMesh>(test::icosphere(n).mesh());
  HolonomySpec spec;
  const auto places = test::spreadVertices(*out.mesh, static_cast<int>(indices.size()));
  for (std::size_t i = 0; i < indices.size(); ++i) spec.cones.push_back({places[i], indices[i]});
  out.options.method = method;
  PreparedSurface surface(*out.mesh);
  std::vector<StageTime> times;
  auto setup = prepareSeamless(surface, spec, {}, times);
  EXPECT_TRUE(setup) << setup.error().message;
  out.problem = std::make_unique<Problem>(
      problemOf(*out.mesh, std::make_shared<const SeamlessSetup>(std::move(*setup)), out.options));
  return out;
}

/// A map whose first `wrong` triangles are not positive, and whose unknowns are all `value`.
std::shared_ptr<Attempt> attemptWith(const Posed& on, int wrong, double value) {
  auto attempt = std::make_shared<Attempt>();
  attempt->program.status = socp::SolveStatus::kOptimal;
  attempt->program.x = Eigen::VectorXcd::Constant(on.problem->setup->unknowns.count, value);
  attempt->certificate.isMeasured = true;
  for (int f = 0; f < wrong; ++f) attempt->wrong.push_back(FaceId(f));
  attempt->certificate.orientation.notPositive = attempt->wrong;
  attempt->wrongCount = wrong;
  return attempt;
}

std::shared_ptr<Attempt> infeasible(const Posed& on, const std::vector<FaceId>& conflict) {
  auto attempt = attemptWith(on, 0, 0.0);
  attempt->program.status = socp::SolveStatus::kInfeasible;
  attempt->program.strained = conflict;
  return attempt;
}

std::vector<FaceId> ringOf(const Posed& on, VertexId v) {
  std::vector<FaceId> faces;
  for (HalfedgeId h : outgoingHalfedges(*on.mesh, v)) faces.push_back(TriMesh::face(h));
  std::sort(faces.begin(), faces.end());
  return faces;
}

MeasuredCone measured(VertexId v, int asked, int k) {
  MeasuredCone cone;
  cone.vertex = v;
  cone.asked = asked;
  cone.measured = k;
  return cone;
}

bool contains(const std::vector<ConePoint>& cones, VertexId v) {
  return std::any_of(cones.begin(), cones.end(), [&](const ConePoint& c) { return c.vertex == v; });
}

TEST(Problem, HasSoftConstraintsOfARingMoreWhereTheDenseSystemStaysSmall) {
  const Posed small = sphere(8), large = sphere(32);
  EXPECT_EQ(small.problem->soft, small.problem->base);
  EXPECT_EQ(large.problem->soft, growFaces(*large.mesh, large.problem->base, 1));
}

TEST(Problem, OfANamedMethodHasItsWeightingAndHarmonicOneMore) {
  for (const Method method :
       {Method::kHarmonic, Method::kSoft, Method::kPrinted, Method::kAllFrames}) {
    const Posed on = sphere(8, std::vector<int>(8, 3), method);
    EXPECT_EQ(on.problem->weightings.size(), method == Method::kHarmonic ? 2U : 1U)
        << methodName(method);
    EXPECT_EQ(methodNamed(methodName(method)), method);
  }
  const Posed all = sphere(8, std::vector<int>(8, 3), Method::kAllFrames);
  EXPECT_EQ(static_cast<int>(firstState(*all.problem).hard.size()), all.mesh->faceCount());
}

TEST(Problem, StartsWithTheHarmonicMapWithoutFrames) {
  const Posed on = sphere(8);
  const State first = firstState(*on.problem);
  EXPECT_EQ(nameOf(*on.problem, first), "harmonic");
  EXPECT_TRUE(first.hard.empty());
}

TEST(ConstrainHarmonic, TakesTheFramesAroundWhatIsWrongAndLaterMore) {
  const Posed on = sphere(8);
  const State first = on.harmonicState();
  const std::vector<FaceId> ring = ringOf(on, on.problem->setup->cones[0]);
  auto failed = attemptWith(on, 0, 1.0);
  failed->wrong = {ring[0]};
  failed->wrongCount = 1;
  const auto next = constrainHarmonic(*on.problem, first, failed);
  ASSERT_TRUE(next);
  EXPECT_EQ(next->hard, ring);
  EXPECT_FALSE(constrainHarmonic(*on.problem, *next, failed)) << "the same again";
  auto elsewhere = attemptWith(on, 0, 1.0);
  const std::vector<FaceId> other = ringOf(on, on.problem->setup->cones[1]);
  elsewhere->wrong = {other[0]};
  const auto more = constrainHarmonic(*on.problem, *next, elsewhere);
  ASSERT_TRUE(more);
  EXPECT_EQ(more->hard.size(), ring.size() + other.size());
  EXPECT_TRUE(std::includes(more->hard.begin(), more->hard.end(), ring.begin(), ring.end()));
  EXPECT_FALSE(constrainHarmonic(*on.problem, first, attemptWith(on, 30, 1.0))) << "too much";
  EXPECT_FALSE(constrainHarmonic(*on.problem, on.softState(), failed));
  Problem large = *on.problem;  // as many unknowns as on a surface with long boundaries
  large.harmonicCount = 2000;
  EXPECT_FALSE(constrainHarmonic(large, first, failed));
}

TEST(HarmonicByAngles, UsesFramesOfAnAngleStructureOnce) {
  const Posed on = sphere(8);
  const AttemptPtr failed = attemptWith(on, 30, 1.0);
  const auto next = harmonicByAngles(*on.problem, on.harmonicState(), failed);
  ASSERT_TRUE(next);
  EXPECT_EQ(next->framedBy, FramedBy::kAngles);
  EXPECT_EQ(next->hard, on.problem->base);
  EXPECT_FALSE(harmonicByAngles(*on.problem, *next, failed));
  Attempts attempts(*on.problem, on.options);
  EXPECT_TRUE(attempts.make(*next, 1)->certificate.isCertified);
}

TEST(FixLifts, OutsideAPatchRingsAreLeftAlone) {
  const Posed on = sphere(32);
  Attempts attempts(*on.problem, on.options);
  const AttemptPtr whole = attempts.make(on.hardState(), 1);
  State patch = on.softState();
  const VertexId far = on.problem->setup->cones[5];
  patch.from = whole;
  patch.hard = ringOf(on, on.problem->setup->cones[0]);
  patch.patch = growFaces(*on.mesh, patch.hard, 3);
  patch.lifts.push_back({far, 3});
  ASSERT_FALSE(std::binary_search(patch.patch.begin(), patch.patch.end(), ringOf(on, far)[0]));
  EXPECT_TRUE(attempts.make(patch, 2)) << "a ring that is not constrained is no error";
}

TEST(FixLifts, EmbedsTheMapsRingOnce) {
  const Posed on = sphere(8);
  const VertexId cone = on.problem->setup->cones[1];
  auto attempt = attemptWith(on, 0, 1.0);
  attempt->certificate.angles.wrong.push_back(measured(cone, 3, 7));
  const auto fixed = fixLifts(*on.problem, on.hardState(), attempt);
  ASSERT_TRUE(fixed);
  EXPECT_TRUE(contains(fixed->lifts, cone));
  EXPECT_EQ(fixed->from, attempt);
  EXPECT_FALSE(fixLifts(*on.problem, *fixed, attempt)) << "nothing is left to change";
}

TEST(FixLifts, LeavesAloneWhatIsNoMultipleOfAFullTurnOrNotPositive) {
  const Posed on = sphere(8);
  const VertexId cone = on.problem->setup->cones[1];
  auto attempt = attemptWith(on, 0, 1.0);
  attempt->certificate.angles.wrong.push_back(measured(cone, 3, 5));
  EXPECT_FALSE(fixLifts(*on.problem, on.hardState(), attempt));
  attempt->certificate.angles.wrong[0].measured = 7;
  attempt->certificate.orientation.notPositive.push_back(ringOf(on, cone)[0]);
  EXPECT_FALSE(fixLifts(*on.problem, on.hardState(), attempt));
}

/// How far f_z is from the positive real axis along the frames, over all triangles.
double farthestFromFrames(const Posed& on, const SeamRotations& seams, const Attempt& attempt) {
  const SeamlessSetup& setup = *on.problem->setup;
  double farthest = 0.0;
  Complex mean = 0.0;
  std::vector<Complex> along;
  for (FaceId f : on.mesh->faces()) {
    const LinearParts parts = linearParts(setup.context->geometry, f);
    Complex similarity = 0.0;
    for (int k = 0; k < 3; ++k)
      similarity +=
          parts.similarity[static_cast<std::size_t>(k)] *
          attempt.program.z[static_cast<std::size_t>(setup.cut.copy[TriMesh::halfedge(f, k)].i)];
    along.push_back(similarity / std::abs(similarity) * std::polar(1.0, seams.frameAngle[f]));
    mean += along.back();
  }
  for (const Complex& a : along)
    farthest = std::max(farthest, std::abs(std::arg(a * std::conj(mean))));
  return farthest;
}

TEST(ShapeFrames, OfACorrectMapAreItsOwnDirections) {
  const Posed on = sphere(8);
  Attempts attempts(*on.problem, on.options);
  const AttemptPtr map = attempts.make(on.hardState(), 1);
  ASSERT_TRUE(map && map->certificate.isCertified);
  const auto frames = framesOfMap(*on.mesh, *on.problem->setup, map->program.z);
  ASSERT_TRUE(frames);
  EXPECT_LT(farthestFromFrames(on, *frames, *map), 1e-9);
  EXPECT_GT(farthestFromFrames(on, on.problem->setup->seams, *map), 1e-3);
}

/// Two cones of 9π/2 beside each other on a torus, and what Lemma 6.2 then needs.
Posed strongPair(int at) {
  Posed on;
  on.mesh = std::make_unique<TriMesh>(test::jittered(test::torus(16, 8), 0.1).mesh());
  HolonomySpec spec;
  const HalfedgeId h = on.mesh->outgoing(VertexId(at));
  spec.cones = {{on.mesh->tail(h), 9}, {on.mesh->head(h), 9}};
  for (const int k : {1, 1, 1, 3})
    spec.cones.push_back({VertexId(60 + 4 * static_cast<int>(spec.cones.size())), k});
  PreparedSurface surface(*on.mesh);
  std::vector<StageTime> times;
  auto setup = prepareSeamless(surface, spec, {}, times);
  EXPECT_TRUE(setup) << setup.error().message;
  on.problem = std::make_unique<Problem>(
      problemOf(*on.mesh, std::make_shared<const SeamlessSetup>(std::move(*setup)), on.options));
  return on;
}

TEST(FrameByAngles, IsFeasibleWhereTheConnectionsFramesContradictEachOther) {
  int contradictions = 0;
  for (int at = 16; at < 40; at += 3) {
    const Posed on = strongPair(at);
    Attempts attempts(*on.problem, on.options);
    const AttemptPtr before = attempts.make(on.hardState(), 1);
    ASSERT_TRUE(before);
    contradictions += !before->isFeasible();
    const auto next = frameByAngles(*on.problem, on.hardState(), before);
    ASSERT_TRUE(next) << at;
    EXPECT_EQ(next->framedBy, FramedBy::kAngles);
    EXPECT_EQ(next->frames->rotation.raw(), on.problem->setup->seams.rotation.raw());
    const AttemptPtr after = attempts.make(*next, 2);
    ASSERT_TRUE(after);
    EXPECT_TRUE(after->isFeasible()) << at;
    EXPECT_FALSE(frameByAngles(*on.problem, *next, after)) << "once";
  }
  EXPECT_GE(contradictions, 2) << "examples that show nothing";
}

TEST(FrameByAngles, IsForHardConstraintsAndNotForThePaperAsPrinted) {
  const Posed soft = sphere(8), printed = sphere(8, std::vector<int>(8, 3), Method::kPrinted);
  EXPECT_FALSE(frameByAngles(*soft.problem, soft.softState(), attemptWith(soft, 3, 1.0)));
  EXPECT_FALSE(
      frameByAngles(*printed.problem, firstState(*printed.problem), attemptWith(printed, 3, 1.0)));
}

/// Two cones of 5π/2 and π/2, and a map that has them the other way round.
struct Swapped {
  Posed on = sphere(6, {5, 1, 3, 3, 3, 3, 3, 3});
  State state = on.hardState();
  Swapped() {
    const Posed other = sphere(6, {1, 5, 3, 3, 3, 3, 3, 3});
    state.frames = std::make_shared<const SeamRotations>(other.problem->setup->seams);
  }
};

TEST(FrameByMap, GivesAMapWithoutFlipsTheConesThatAreAsked) {
  const Swapped swapped;
  const Posed& on = swapped.on;
  Attempts attempts(*on.problem, on.options);
  const AttemptPtr wrong = attempts.make(swapped.state, 1);
  ASSERT_TRUE(wrong);
  ASSERT_TRUE(wrong->certificate.orientation.notPositive.empty());
  EXPECT_EQ(wrong->certificate.angles.wrong.size(), 2U) << "an example that shows nothing";
  const auto next = frameByMap(*on.problem, swapped.state, wrong);
  ASSERT_TRUE(next);
  EXPECT_EQ(next->framedBy, FramedBy::kMap);
  EXPECT_EQ(next->from, wrong);
  const AttemptPtr right = attempts.make(*next, 2);
  ASSERT_TRUE(right);
  EXPECT_TRUE(right->certificate.isCertified);
}

TEST(FrameByMap, ContinuesWhileItHelpsAndOnlyWithFewFlips) {
  const Swapped swapped;
  const Posed& on = swapped.on;
  Attempts attempts(*on.problem, on.options);
  const AttemptPtr wrong = attempts.make(swapped.state, 1);
  ASSERT_TRUE(wrong);
  const auto next = frameByMap(*on.problem, swapped.state, wrong);
  ASSERT_TRUE(next);
  EXPECT_FALSE(frameByMap(*on.problem, *next, wrong)) << "no better than the map before";
  auto better = std::make_shared<Attempt>(*wrong);
  better->wrongCount = 1;
  EXPECT_TRUE(frameByMap(*on.problem, *next, better));
  better->certificate.orientation.notPositive.push_back(FaceId(0));
  EXPECT_TRUE(frameByMap(*on.problem, *next, better)) << "one crushed triangle";
  // Of a cone program: one triangle and its vertices; of untangling: a share of the triangles.
  better->wrongCount = 4;
  EXPECT_TRUE(frameByMap(*on.problem, swapped.state, better));
  better->wrongCount = 5;
  EXPECT_FALSE(frameByMap(*on.problem, swapped.state, better));
  State untangled = swapped.state;
  untangled.untangling = 0;
  better->wrongCount = on.problem->mesh.faceCount() / 50;
  EXPECT_FALSE(frameByMap(*on.problem, untangled, better));
}

TEST(Patch, IsSolvedAroundWhatIsWrongWidenedWhereWorseAndFollowedByHardConstraints) {
  const Posed on = sphere(32);
  const State soft = on.softState();
  const AttemptPtr first = attemptWith(on, 2, 1.0);
  const auto patch = solvePatch(*on.problem, soft, first);
  ASSERT_TRUE(patch) << "two wrong triangles need no program of everything";
  EXPECT_EQ(patch->from, first);
  EXPECT_EQ(patch->hard, growFaces(*on.mesh, {FaceId(0), FaceId(1)}, 1));
  EXPECT_FALSE(patch->isWide);

  const AttemptPtr worse = attemptWith(on, 5, 2.0);
  EXPECT_FALSE(solvePatch(*on.problem, *patch, worse));
  const auto wide = widenPatch(*on.problem, *patch, worse);
  ASSERT_TRUE(wide);
  EXPECT_EQ(wide->from, first) << "the map before the one that was worse";
  EXPECT_GT(wide->patch.size(), 3 * patch->patch.size());

  const AttemptPtr better = attemptWith(on, 1, 3.0);
  const auto second = solvePatch(*on.problem, *patch, better);
  ASSERT_TRUE(second);
  EXPECT_TRUE(second->isWide) << "one patch was not enough";
  EXPECT_EQ(second->from, better);

  EXPECT_FALSE(widenPatch(*on.problem, *wide, worse));
  const auto hard = nextWeighting(*on.problem, *wide, worse);
  ASSERT_TRUE(hard);
  EXPECT_TRUE(hard->patch.empty());
  EXPECT_EQ(hard->hard, on.problem->base);
}

TEST(Patch, IsNoLargePartOfTheMesh) {
  const Posed on = sphere(4);
  const auto next = solvePatch(*on.problem, on.softState(), attemptWith(on, 2, 1.0));
  EXPECT_TRUE(!next || next->patch.empty());
}

TEST(Enlarge, AddsWhatIsWrongAndARingAndRemembersTheMap) {
  const Posed on = sphere(16);
  const AttemptPtr attempt = attemptWith(on, 4, 1.0);
  const auto next = enlarge(*on.problem, on.hardState(), attempt);
  ASSERT_TRUE(next);
  EXPECT_EQ(next->from, attempt);
  for (FaceId f : growFaces(*on.mesh, attempt->wrong, 1))
    EXPECT_TRUE(std::binary_search(next->hard.begin(), next->hard.end(), f));
  EXPECT_GT(next->hard.size(), on.problem->base.size());
  EXPECT_FALSE(enlarge(*on.problem, on.hardState(), infeasible(on, {FaceId(0)})))
      << "nothing is learned from an infeasible program";
}

TEST(Enlarge, MayTakeAllOfASmallMesh) {
  const Posed on = sphere(8);
  const AttemptPtr all = attemptWith(on, on.mesh->faceCount(), 1.0);
  const auto next = enlarge(*on.problem, on.hardState(), all);
  ASSERT_TRUE(next) << "a share of the mesh is no measure of work";
  EXPECT_EQ(static_cast<int>(next->hard.size()), on.mesh->faceCount());
}

TEST(Untangle, GoesThroughItsKindsWithinABudgetOfSteps) {
  const Posed on = sphere(8);
  State state = on.hardState();
  auto attempt = attemptWith(on, 4, 1.0);
  attempt->program.iterations = 10;
  std::size_t kinds = 0;
  for (auto next = untangleNext(*on.problem, state, attempt); next;
       next = untangleNext(*on.problem, state, attempt)) {
    EXPECT_EQ(next->untangling, static_cast<int>(kinds++));
    state = *next;
  }
  EXPECT_EQ(kinds, untanglings().size());
  const auto after = nextWeighting(*on.problem, state, attempt);
  ASSERT_TRUE(after);
  EXPECT_FALSE(untangleNext(*on.problem, *after, attempt)) << "once in a run";

  attempt->program.iterations = 1'000'000'000 / on.mesh->faceCount();
  State first = on.hardState();
  first.untangling = 0;
  EXPECT_FALSE(untangleNext(*on.problem, first, attempt)) << "the budget is spent";
}

TEST(Untangle, IsLeftOutWhereAStepTakesSeconds) {
  const Posed on = sphere(8);
  const Problem& p = *on.problem;
  const auto isTriedFor = [&](const TriMesh& mesh) {
    const Problem other{mesh,   p.setup,          p.method,        p.weightings, p.base,
                        p.soft, p.hasGivenFrames, p.harmonicCount, 1e12,         p.angles};
    return untangleNext(other, on.hardState(), attemptWith(on, 4, 1.0)).has_value();
  };
  EXPECT_TRUE(isTriedFor(*on.mesh));
  EXPECT_FALSE(isTriedFor(TriMesh(test::grid(330, 330).mesh()))) << "2 × 330² triangles";
}

TEST(Untangle, EveryKindGivesACertifiedMapOfAPrescriptionThatHardConstraintsFail) {
  // Found among random prescriptions: F_cb alone leaves hundreds of triangles folded.
  Posed on;
  on.mesh = std::make_unique<TriMesh>(test::jittered(test::pretzel(2, 5), 0.08).mesh());
  HolonomySpec spec;
  spec.q = 8;
  const auto places = test::spreadVertices(*on.mesh, 4);
  for (const VertexId v : places) spec.cones.push_back({v, 12});
  spec.handles = {3, 5, 1, 6};
  PreparedSurface surface(*on.mesh);
  std::vector<StageTime> times;
  auto setup = prepareSeamless(surface, spec, {}, times);
  ASSERT_TRUE(setup) << setup.error().message;
  on.problem = std::make_unique<Problem>(
      problemOf(*on.mesh, std::make_shared<const SeamlessSetup>(std::move(*setup)), on.options));
  Attempts attempts(*on.problem, on.options);
  const AttemptPtr hard = attempts.make(on.hardState(), 1);
  ASSERT_TRUE(hard);
  EXPECT_FALSE(hard->certificate.isCertified) << "an example that shows nothing";
  int certified = 0;
  for (std::size_t kind = 0; kind < untanglings().size(); ++kind) {
    State state = startOf(*on.problem, on.indexOf("hard constraints"));
    state.untangling = static_cast<int>(kind);
    state.framedBy = untanglings()[kind].framedBy;
    if (state.framedBy == FramedBy::kAngles)
      state.frames = on.problem->angles->get(*on.mesh, *on.problem->setup);
    const AttemptPtr attempt = attempts.make(state, 1);
    ASSERT_TRUE(attempt);
    certified += attempt->certificate.isCertified;
  }
  EXPECT_GE(certified, 4) << "of " << untanglings().size();
}

TEST(NextWeighting, StartsFromFcbAndEndsWithTheLast) {
  const Posed on = sphere(8);
  State state = on.softState();
  std::size_t count = on.indexOf("soft constraints, exact rows") + 1;
  for (auto next = nextWeighting(*on.problem, state, attemptWith(on, 2, 1.0)); next;
       next = nextWeighting(*on.problem, state, attemptWith(on, 2, 1.0)), ++count) {
    EXPECT_EQ(next->hard, on.problem->base);
    EXPECT_EQ(next->growth, 0);
    state = *next;
  }
  EXPECT_EQ(count, on.problem->weightings.size());
}

TEST(NextWeighting, KeepsTheScaleOfTheLastFeasibleMap) {
  const Posed on = sphere(8);
  const AttemptPtr good = attemptWith(on, 2, 1.0);
  const auto second = nextWeighting(*on.problem, firstState(*on.problem), good);
  ASSERT_TRUE(second);
  const auto third = nextWeighting(*on.problem, *second, infeasible(on, {}));
  ASSERT_TRUE(third);
  EXPECT_EQ(third->from, good) << "nothing is learned from an infeasible program";
}

TEST(IterateFrames, TakesFramesAndWeightsOfTheMap) {
  const Posed on = sphere(8, std::vector<int>(8, 3), Method::kPrinted);
  Attempts attempts(*on.problem, on.options);
  const AttemptPtr first = attempts.make(firstState(*on.problem), 1);
  ASSERT_TRUE(first);
  const auto next = iterateFrames(*on.problem, firstState(*on.problem), first);
  ASSERT_TRUE(next);
  ASSERT_TRUE(next->directions && next->harmonic);
  EXPECT_NE(next->directions->angles, first->frames.angles);
  EXPECT_EQ(next->harmonic->rows.rows(), on.problem->setup->harmonic.rows.rows());
  EXPECT_GT((next->harmonic->rows - on.problem->setup->harmonic.rows).norm(), 1e-6);
  const Posed own = sphere(8);
  EXPECT_FALSE(iterateFrames(*own.problem, firstState(*own.problem), first));
}

TEST(Hash, DistinguishesStatesThatPoseDifferentPrograms) {
  const Posed on = sphere(8);
  const State hard = on.hardState();
  State angles = hard, other = hard, remembered = hard;
  angles.framedBy = FramedBy::kAngles;
  other.hard.pop_back();
  remembered.from = attemptWith(on, 1, 2.0);
  remembered.untangled = 3;
  EXPECT_NE(hashOf(hard), hashOf(angles));
  EXPECT_NE(hashOf(hard), hashOf(other));
  EXPECT_EQ(hashOf(hard), hashOf(remembered)) << "what is remembered poses no other program";
}

TEST(Strategy, NeverTriesAStateTwice) {
  // Strong cones side by side, whose rings fight.
  const TriMesh mesh = test::jittered(test::torus(16, 8), 0.1).mesh();
  HolonomySpec spec;
  const HalfedgeId h = mesh.outgoing(VertexId(20));
  spec.cones = {{mesh.tail(h), 11}, {mesh.head(h), 1}, {VertexId(60), 1}, {VertexId(90), 3}};
  const Result<Parametrization> p = parametrize(mesh, spec, {});
  ASSERT_TRUE(p) << p.error().message;
  std::vector<std::string> names;
  for (const Round& round : p->rounds)
    names.push_back(round.method + std::to_string(round.constrainedTriangles));
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
}

}  // namespace
}  // namespace hgp
