#include "hgp/parametrize/moves/moves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hgp/parametrize/attempt.h"
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
  attempt->program.conflict = conflict;
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

TEST(Problem, OfANamedMethodHasItsWeightingAlone) {
  for (const Method method :
       {Method::kHarmonic, Method::kSoft, Method::kPrinted, Method::kAllFrames}) {
    const Posed on = sphere(8, std::vector<int>(8, 3), method);
    EXPECT_EQ(on.problem->weightings.size(), 1U) << methodName(method);
    EXPECT_EQ(methodNamed(methodName(method)), method);
  }
  const Posed all = sphere(8, std::vector<int>(8, 3), Method::kAllFrames);
  EXPECT_EQ(static_cast<int>(firstState(*all.problem).hard.size()), all.mesh->faceCount());
}

TEST(EmbedRings, TakesTheConesOfTheConflictOnceAndNeverTwice) {
  const Posed on = sphere(8);
  const VertexId cone = on.problem->setup->cones[2];
  const AttemptPtr fight = infeasible(on, ringOf(on, cone));
  const auto next = embedRings(*on.problem, on.hardState(), fight);
  ASSERT_TRUE(next);
  ASSERT_EQ(next->rings.size(), 1U);
  EXPECT_EQ(next->rings[0].vertex, cone);
  EXPECT_FALSE(embedRings(*on.problem, *next, fight)) << "it is embedded already";
  State back = on.hardState();
  back.takenBack.push_back(cone);
  EXPECT_FALSE(embedRings(*on.problem, back, fight)) << "taken back is taken back";
  EXPECT_FALSE(embedRings(*on.problem, on.hardState(), attemptWith(on, 3, 1.0)));
}

TEST(EmbedRings, ChangesTheFramesOfTheRingAndOfNothingElse) {
  const Posed on = sphere(8, {1, 3, 3, 3, 3, 3});
  const VertexId cone = on.problem->setup->cones[0];
  Attempts attempts(*on.problem, on.options);
  const AttemptPtr before = attempts.make(on.hardState(), 1);
  State ringed = on.hardState();
  ringed.rings.push_back(on.problem->setup->field.spec.cones[0]);
  const AttemptPtr after = attempts.make(ringed, 2);
  ASSERT_TRUE(before && after);
  const std::vector<FaceId> ring = ringOf(on, cone);
  int changed = 0;
  for (std::size_t i = 0; i < before->frames.faces.size(); ++i) {
    const bool isChanged = before->frames.angles[i] != after->frames.angles[i];
    changed += isChanged;
    EXPECT_TRUE(!isChanged ||
                std::binary_search(ring.begin(), ring.end(), before->frames.faces[i]));
  }
  EXPECT_GT(changed, 0);
}

TEST(EmbedRings, OutsideAPatchRingsAreLeftAlone) {
  const Posed on = sphere(32);
  Attempts attempts(*on.problem, on.options);
  const AttemptPtr whole = attempts.make(on.hardState(), 1);
  State patch = firstState(*on.problem);
  const VertexId far = on.problem->setup->cones[5];
  patch.from = whole;
  patch.hard = ringOf(on, on.problem->setup->cones[0]);
  patch.patch = growFaces(*on.mesh, patch.hard, 3);
  patch.rings.push_back({far, 3});
  ASSERT_FALSE(std::binary_search(patch.patch.begin(), patch.patch.end(), ringOf(on, far)[0]));
  EXPECT_TRUE(attempts.make(patch, 2)) << "a ring that is not constrained is no error";
}

TEST(FixLifts, GivesBackTheConnectionsLiftAndThenEmbedsTheMapsRing) {
  const Posed on = sphere(8);
  const VertexId cone = on.problem->setup->cones[1];
  auto attempt = attemptWith(on, 0, 1.0);
  attempt->certificate.angles.wrong.push_back(measured(cone, 3, 7));
  State state = on.hardState();
  state.rings.push_back({cone, 3});
  const auto back = fixLifts(*on.problem, state, attempt);
  ASSERT_TRUE(back);
  EXPECT_FALSE(contains(back->rings, cone));
  EXPECT_EQ(back->takenBack, std::vector<VertexId>{cone});
  const auto fixed = fixLifts(*on.problem, *back, attempt);
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

TEST(TurnEvenly, DerivesOtherFramesWithTheSameSeams) {
  const Posed on = sphere(8, {1, 3, 3, 3, 3, 3});
  const auto next = turnEvenly(*on.problem, on.hardState(), infeasible(on, {}));
  ASSERT_TRUE(next);
  EXPECT_TRUE(next->isEven);
  EXPECT_FALSE(turnEvenly(*on.problem, *next, infeasible(on, {})));
  EXPECT_FALSE(turnEvenly(*on.problem, on.hardState(), attemptWith(on, 3, 1.0)));
  Attempts attempts(*on.problem, on.options);
  const AttemptPtr plain = attempts.make(on.hardState(), 1), even = attempts.make(*next, 2);
  ASSERT_TRUE(plain && even);
  EXPECT_NE(plain->frames.angles, even->frames.angles);
  EXPECT_TRUE(even->certificate.isCertified) << "the holonomy is the same";
}

TEST(DropFrames, TakesTheConflictOutOfTheConstrainedSetButNeverMostOfIt) {
  const Posed on = sphere(8);
  const std::vector<FaceId> ring = ringOf(on, on.problem->setup->cones[0]);
  const auto next = dropFrames(*on.problem, on.hardState(), infeasible(on, ring));
  ASSERT_TRUE(next);
  EXPECT_EQ(next->hard.size() + ring.size(), on.problem->base.size());
  EXPECT_FALSE(dropFrames(*on.problem, on.hardState(), infeasible(on, on.problem->base)));
  EXPECT_FALSE(dropFrames(*on.problem, on.hardState(), attemptWith(on, 3, 1.0)));
}

TEST(Patch, IsSolvedAroundWhatIsWrongWidenedWhereWorseAndFollowedByHardConstraints) {
  const Posed on = sphere(32);
  const State soft = firstState(*on.problem);
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
  const auto next = solvePatch(*on.problem, firstState(*on.problem), attemptWith(on, 2, 1.0));
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
    const AttemptPtr attempt = attempts.make(state, 1);
    ASSERT_TRUE(attempt);
    certified += attempt->certificate.isCertified;
  }
  EXPECT_GE(certified, 4);
}

TEST(NextWeighting, StartsFromFcbAndEndsWithTheLast) {
  const Posed on = sphere(8);
  State state = firstState(*on.problem);
  std::size_t count = 1;
  for (auto next = nextWeighting(*on.problem, state, attemptWith(on, 2, 1.0)); next;
       next = nextWeighting(*on.problem, state, attemptWith(on, 2, 1.0)), ++count) {
    EXPECT_EQ(next->hard, on.problem->base);
    EXPECT_EQ(next->growth, 0);
    state = *next;
  }
  EXPECT_EQ(count, on.problem->weightings.size());
}

TEST(NextWeighting, KeepsTheScaleOfTheLastMapThatWasOne) {
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

TEST(Hash, TellsStatesApartThatPoseOtherPrograms) {
  const Posed on = sphere(8);
  const State hard = on.hardState();
  State even = hard, other = hard, remembered = hard;
  even.isEven = true;
  other.hard.pop_back();
  remembered.from = attemptWith(on, 1, 2.0);
  remembered.takenBack.push_back(VertexId(3));
  EXPECT_NE(hashOf(hard), hashOf(even));
  EXPECT_NE(hashOf(hard), hashOf(other));
  EXPECT_EQ(hashOf(hard), hashOf(remembered)) << "what is remembered poses no other program";
}

TEST(Strategy, NeverTriesAStateTwice) {
  // Strong cones side by side, whose rings fight: rings embedded and taken back used to alternate.
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
