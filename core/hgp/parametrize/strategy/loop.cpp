#include "hgp/parametrize/strategy/loop.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <set>
#include <utility>

#include "hgp/base/counted.h"
#include "hgp/parametrize/after/free_rotation.h"
#include "hgp/parametrize/after/own_cones.h"
#include "hgp/parametrize/after/solution.h"
#include "hgp/parametrize/round.h"
#include "hgp/parametrize/seamless_setup.h"
#include "hgp/parametrize/stage_clock.h"
#include "hgp/parametrize/strategy/attempt.h"
#include "hgp/parametrize/strategy/found.h"
#include "hgp/parametrize/strategy/moves/moves.h"

namespace hgp {
namespace {

/// A harmonic map of more mean μ than this is compared with the one for cotangent weights and with the next map that is
/// certified.
constexpr double kDistorted = 0.06;
/// Where boundaries are long, the next map costs as much as the harmonic one, and harmonic maps of long triangles beside them
/// may have three times as much.
constexpr double kDistortedLong = 0.01;

/// Whether the next weighting is tried although `best` is a certified harmonic map. Orbifolds have one harmonic map, to which
/// soft constraints are no alternative. On flat tori with irregular triangles the cotangent weights, the only ones that give
/// a harmonic map, often give one of much μ.
bool isCompared(const Problem& problem, const State& state, const Attempt& best) {
  const std::size_t next = state.weighting + 1;
  const Weighting& weighting = problem.weightings[state.weighting];
  if (!best.certificate.isCertified || !weighting.isHarmonic || next >= problem.weightings.size())
    return false;
  const bool isTorus = state.weighting == 0 && weighting.rows == WeightKind::kCotangent;
  const bool hasRival = problem.weightings[next].soft > 0.0 ||
                        problem.weightings[next].rows == WeightKind::kCotangent;
  const double limit = weighting.quality > 0.0 ? kDistortedLong : kDistorted;
  return isTorus || (hasRival && meanMuOf(best) > limit);
}

/// A map that is wrong only by the cones it was asked for. (Others may be too fine for float64 besides.)
void addOwn(const Problem& problem, const std::shared_ptr<const Attempt>& attempt, Found& found) {
  const Certificate& c = attempt->certificate;
  if (c.isCertified || !c.isMeasured || !c.orientation.notPositive.empty()) return;
  if (found.unfolded && attempt->wrongCount >= found.unfolded->wrongCount) return;
  const CompleteSpec own = ownPrescription(problem.setup->field.spec, c);
  if (certify(problem.mesh, toSpec(own), attempt->map).isCertified) found.unfolded = attempt;
}

void explain(const SeamlessSetup& setup, bool hasGivenFrames, const Attempt& best,
             Parametrization& result) {
  const double range = setup.field.scaleRange;
  if (range > kHopelessScaleRange && !result.isCertified)
    result.notes.push_back(Note("map-unresolved", {{"range", static_cast<int>(range)}}));
  else if (range > kHardScaleRange)
    result.notes.push_back(Note("map-stretched", {{"range", static_cast<int>(range)}}));
  if (!result.strained.empty()) {
    const bool isProven = best.program.status == socp::SolveStatus::kInfeasible;
    result.notes.push_back(
        Note(isProven ? "map-frames-contradict" : "map-frames-unmet",
             {{"frames", best.frames.faces.size()}, {"strained", result.strained.size()}}));
  }
  if (!result.isCertified && hasGivenFrames) result.notes.push_back(Note("map-given-frames"));
}

using Clock = std::chrono::steady_clock;
double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The moves in order: local repairs first, then other frames, then everything again with another weighting.
constexpr Move kMoves[] = {constrainHarmonic, harmonicByAngles, frameByMap,    widenPatch,
                           solvePatch,        fixLifts,         frameByAngles, untangleNext,
                           enlarge,           iterateFrames,    nextWeighting};

/// The first move to a state that was not tried before.
std::optional<State> firstMove(const Problem& problem, const State& state,
                               const std::shared_ptr<const Attempt>& attempt,
                               const std::set<std::uint64_t>& tried) {
  for (const Move move : kMoves) {
    std::optional<State> next = move(problem, state, attempt);
    if (next && !tried.contains(hashOf(*next))) return next;
  }
  return {};
}

/// Whether untangling begins again, with other weights or frames. A map without folds but with other cones is mended before
/// that if it can be (frameByMap).
bool isOtherStart(const State& next, const State& state) {
  return state.untangling >= 0 &&
         (next.untangling != state.untangling || next.weighting != state.weighting);
}

}  // namespace

struct PausedSearch {
  std::shared_ptr<const SeamlessSetup> setup;
  std::shared_ptr<AngleFrames> angles;
  Found found;
  std::set<std::uint64_t> tried;
  State state;
  std::shared_ptr<const Attempt> attempt;  ///< of `state`; the next move is asked after it
  int round = 0;
  double spent = 0.0;  ///< faceStepsOf

  /// Gives a problem of the same setup the frames of angles that are known, or begins with its first state.
  void connect(Problem& problem) {
    if (!angles) {
      angles = problem.angles;
      state = firstState(problem);
    }
    problem.angles = angles;
  }
};

/// The loop [BCW17 §7]: solve and verify a state, keep the best map, take the first move that applies; until a map is
/// certified, no move applies, or the steps or the rounds are spent.
/// @param at            where it begins and ends; `attempt` is null at the end if it is not to go on
/// @param isImpossible  asked once, after a first round without a map
static Result<std::shared_ptr<const Attempt>> solve(const Problem& problem,
                                                    const ParametrizeOptions& options,
                                                    const std::function<bool()>& isImpossible,
                                                    PausedSearch& at, std::vector<Round>& rounds) {
  Attempts attempts(problem, options);
  Found& found = at.found;
  bool isNext = true;
  if (const auto last = std::exchange(at.attempt, nullptr)) {
    std::optional<State> next = firstMove(problem, at.state, last, at.tried);
    isNext = next && !(found.unfolded && isOtherStart(*next, at.state));
    if (isNext) at.state = std::move(*next);
  }
  while (isNext && at.round < options.maxRounds) {
    const int round = ++at.round;
    if (!report(options.progress, {Stage::kSolve, 0.0, -1, -1.0, round, options.maxRounds}))
      return cancelled(Stage::kSolve);
    const auto start = Clock::now();
    const State& state = at.state;
    at.tried.insert(hashOf(state));
    const std::shared_ptr<const Attempt> attempt = attempts.make(state, round);
    if (!attempt) return cancelled(Stage::kSolve);
    rounds.push_back(roundOf(nameOf(problem, state), attempt->frames.faces.size(), attempt->program,
                             attempt->certificate, secondsSince(start)));
    found.add(attempt, problem.weightings[state.weighting].isHarmonic);
    if (options.areConesFree) addOwn(problem, attempt, found);
    at.spent += faceStepsOf(rounds.back(), problem.mesh.faceCount());
    const bool isCertified = attempt->certificate.isCertified;
    const bool isOdd = isCompared(problem, state, *found.best);
    if (isCertified && !isOdd) break;
    if (at.spent >= problem.maxFaceSteps) {
      if (!found.best->certificate.isCertified) at.attempt = attempt;
      break;
    }
    // Where no map on this mesh has the angles, the map of one round shows --refine which edges to split.
    if (round == 1 && !isCertified && isImpossible()) break;
    std::optional<State> next = isOdd ? nextWeighting(problem, state, attempt)
                                      : firstMove(problem, state, attempt, at.tried);
    if (!next || (found.unfolded && isOtherStart(*next, state))) break;
    at.state = std::move(*next);
  }
  if (!found.best) return Failure{ErrorCode::kUsage, "solve", "At least one round is needed.", {}};
  return found.unfolded && !found.best->certificate.isCertified ? found.unfolded : found.best;
}

/// What is asked for besides a map, or needed for one that float64 holds.
static Status improveAndAlign(const TriMesh& mesh, const ParametrizeOptions& options,
                              bool isOnlyTooFine, MappedSolution& mapped, Parametrization& result) {
  if (isOnlyTooFine && options.method == Method::kAuto)
    if (Status done = evenOut(mesh, options, mapped, result); !done) return done;
  if (mapped.certificate.isCertified && options.improve)
    if (Status done = improveSolution(mesh, options, mapped, result); !done) return done;
  if (mapped.certificate.isCertified && options.grid.isAsked())
    return alignSolution(mesh, options, mapped, result);
  return Done{};
}

static Result<std::shared_ptr<PausedSearch>> newSearch(PreparedSurface& surface,
                                                       const HolonomySpec& spec,
                                                       const ParametrizeOptions& options,
                                                       std::vector<StageTime>& times) {
  Result<SeamlessSetup> prepared = prepareSeamless(surface, spec, options, times);
  if (!prepared) return std::move(prepared).error();
  auto at = std::make_shared<PausedSearch>();
  at->setup = std::make_shared<const SeamlessSetup>(std::move(*prepared));
  return at;
}

Result<Parametrization> parametrizeInMetric(PreparedSurface& surface, const HolonomySpec& spec,
                                            const ParametrizeOptions& options,
                                            std::shared_ptr<PausedSearch>* paused) {
  const TriMesh& mesh = surface.mesh();
  Parametrization result;
  std::shared_ptr<PausedSearch> at = paused ? std::exchange(*paused, nullptr) : nullptr;
  if (!at) {
    Result<std::shared_ptr<PausedSearch>> search = newSearch(surface, spec, options, result.times);
    if (!search) return std::move(search).error();
    at = std::move(*search);
  }
  const std::shared_ptr<const SeamlessSetup>& setup = at->setup;
  result.spec = setup->field.spec;
  result.notes = setup->warnings;

  const auto start = Clock::now();
  Problem problem = problemOf(mesh, setup, options);
  at->connect(problem);
  const auto isImpossible = [&] {
    std::optional<Note> proof;
    if (!setup->isTooCoarse)
      proof = proveImpossible(mesh, surface.topology(), spec, surface.shortages().nearAngles());
    if (proof) result.notes.push_back(std::move(*proof));
    result.isImpossible = setup->isTooCoarse || proof;
    return result.isImpossible;
  };
  Result<std::shared_ptr<const Attempt>> best =
      solve(problem, options, isImpossible, *at, result.rounds);
  if (!best) return std::move(best).error();
  if (paused && at->attempt) *paused = at;
  result.times.push_back({Stage::kSolve, secondsSince(start)});
  const Attempt& attempt = **best;
  MappedSolution mapped{
      {setup, attempt.program.x, attempt.u, attempt.frames}, attempt.map, attempt.certificate};
  if (options.areConesFree) keepOwnCones(mesh, mapped, result);
  (options.frames ? turnAsFramesSay : turnAsTheSurfaceLies)(mesh, mapped);
  const bool isOnlyTooFine = !mapped.certificate.isCertified && attempt.wrongCount == 0;
  if (Status done = improveAndAlign(mesh, options, isOnlyTooFine, mapped, result); !done)
    return std::move(done).error();
  result.map = std::move(mapped.map);
  result.certificate = std::move(mapped.certificate);
  if (!result.certificate.isCertified) result.strained = attempt.program.strained;
  result.copyOf = setup->cut.parent.raw();
  result.isCertified = result.certificate.isCertified;
  result.isUsable = result.certificate.isUsable;
  explain(*setup, options.frames.has_value(), attempt, result);
  return result;
}

}  // namespace hgp
