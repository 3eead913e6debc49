#include "hgp/parametrize/along/along_features.h"

#include <algorithm>
#include <utility>

#include "hgp/base/check.h"
#include "hgp/features/field_along.h"
#include "hgp/features/index_flow.h"
#include "hgp/features/step_repair.h"
#include "hgp/parametrize/after/real_pairs.h"
#include "hgp/parametrize/after/solution.h"
#include "hgp/parametrize/along/along_grid.h"
#include "hgp/parametrize/along/index_search.h"
#include "hgp/parametrize/stage_clock.h"

namespace hgp {
namespace {

/// Steps that are straightened at most, because lengths contradict each other.
constexpr int kMaxSteps = 8;

Failure refusal(std::string message) {
  return {ErrorCode::kUsage, "features", std::move(message), {}};
}

Status checkOptions(const PreparedSurface& surface, const HolonomySpec& spec,
                    const ParametrizeOptions& options) {
  if (spec.q != 4)
    return refusal("features need q = 4; these cones have q = " + std::to_string(spec.q) + ".");
  if (options.frames) return refusal("Frames of a file do not go with features; leave out either.");
  const Topology& topology = surface.context().topology;
  // What corners of rims turn by is compared by their patches.
  if (spec.cones.empty() || !spec.corners.empty())
    return checkBounds(surface.mesh(), topology, spec);
  const Result<BudgetReport> budget = checkSums(surface.mesh(), topology, spec);
  return budget ? Status(Done{}) : budget.error();
}

bool isAnyOther(const std::vector<std::optional<int>>& asked, const std::vector<int>& found) {
  for (std::size_t i = 0; i < asked.size() && i < found.size(); ++i)
    if (asked[i] && *asked[i] != found[i]) return true;
  return false;
}

/// Turnings and rotations that are prescribed beside features must be those of the field along them.
Status checkTurns(const HolonomySpec& asked, const CompleteSpec& found) {
  if (!isAnyOther(asked.turning, found.turning) && !isAnyOther(asked.handles, found.handles))
    return Done{};
  return Failure{ErrorCode::kPrescription,
                 "features",
                 "With features, turnings and rotations along handles are those of a field along "
                 "them, which are not the prescribed ones. Leave out these or the features.",
                 {}};
}

/// The given features and all boundary edges, ascending.
std::vector<EdgeId> withRims(const TriMesh& mesh, std::vector<EdgeId> features) {
  for (EdgeId e : mesh.edges())
    if (mesh.isBoundary(mesh.halfedge(e))) features.push_back(e);
  std::sort(features.begin(), features.end());
  features.erase(std::unique(features.begin(), features.end()), features.end());
  return features;
}

/// What the programs of one field led to.
struct StraightOutcome {
  StraightSetup setup;
  StraightAttempt attempt;
};

/// Solves along one field after another. Where lengths contradict each other, which is known before a program is solved, the
/// shortest step among the contradicting edges is straightened, and where that does not help, the next one. If no step helps,
/// units of the first field are moved.
class StepSearch {
 public:
  StepSearch(PreparedSurface& surface, const ParametrizeOptions& options, Parametrization& result)
      : surface_(surface), options_(options), result_(result) {}

  Result<StraightOutcome> run(StraightSetup setup) {
    for (;;) {
      StageClock clock(options_.progress, result_.times);
      if (!clock.begin(Stage::kSolve)) return clock.cancelled();
      StraightRun run(surface_.mesh(), setup, options_, result_.rounds);
      const std::vector<HalfedgeId>& edges = run.shortEdges();
      std::optional<StraightSetup> next;
      isCutShort_ = isLast();
      if (!edges.empty() && !isCutShort_) {
        clock.end();
        if (Status done = prepareNext(setup, edges, next); !done) return std::move(done).error();
        if (next) {
          setup = std::move(*next);
          continue;
        }
        if (!clock.begin(Stage::kSolve)) return clock.cancelled();
      }
      completeStraight(surface_.mesh(), setup);
      std::optional<StraightAttempt> attempt = run.run();
      if (!attempt) return clock.cancelled();
      clock.end();
      contradicting_ = run.isContradictionShown() ? static_cast<int>(edges.size()) : 0;
      const bool isFound = attempt->certificate.isCertified;
      if (!isFound && !isLast() && edges.empty())
        if (Status done = prepareNext(setup, {}, next); !done) return std::move(done).error();
      if (!next) return StraightOutcome{std::move(setup), std::move(*attempt)};
      setup = std::move(*next);
    }
  }

  /// No field with possible lengths was found.
  bool isContradicting() const { return contradicting_ > 0 && !isCutShort_; }

  void note() const {
    if (contradicting_ > 0)
      result_.notes.push_back(Note("features-contradict", {{"edges", contradicting_}}));
    if (straightened_ > 0 && contradicting_ == 0)
      result_.notes.push_back(Note("features-straightened", {{"steps", straightened_}}));
    if (moved_ > 0 && contradicting_ == 0)
      result_.notes.push_back(Note("features-moved", {{"units", moved_}}));
  }

 private:
  /// The rounds are those of all fields together; a run that may take none has no map.
  bool isLast() const { return static_cast<int>(result_.rounds.size()) >= options_.maxRounds; }

  /// What comes after a field of which these edges contradict each other, or, where none do, that has no map. Nothing if
  /// there is no other field.
  Status prepareNext(const StraightSetup& setup, const std::vector<HalfedgeId>& edges,
                     std::optional<StraightSetup>& next) {
    std::optional<AlignedField> field;
    if (!edges.empty() && !isSearched_ && static_cast<int>(tried_.size()) < kMaxSteps)
      field = nextField(setup.aligned, edges);
    if (field) {
      if (!first_) first_ = setup;
      ++straightened_;
    } else if (Status done = search(setup, edges.empty(), field); !done) {
      return done;
    }
    if (!field) return Done{};
    Result<StraightSetup> prepared = prepareLengths(surface_, setup.seamless.field.spec.features,
                                                    std::move(*field), options_, result_.times);
    if (prepared) next = std::move(*prepared);
    return Done{};
  }

  /// A field with other indices: one with possible lengths and no flat triangle, where the first field has not; or one with
  /// a map, if this one has possible lengths.
  Status search(const StraightSetup& setup, bool arePossible, std::optional<AlignedField>& next) {
    const auto take = [&](const StraightSetup& start, IndexGoal goal) -> Status {
      IndexSearch found = searchIndices(surface_, start, goal, options_);
      if (found.isCancelled) return cancelled(Stage::kSolve);
      if (!found.field) return Done{};
      next = std::move(found.field);
      straightened_ = 0;
      moved_ += found.moves;
      first_.reset();
      return Done{};
    };
    if (!std::exchange(isSearched_, true))
      if (Status done = take(first_ ? *first_ : setup, IndexGoal::kLengths); !done) return done;
    if (!next && arePossible && !std::exchange(isSearchedForMaps_, true))
      return take(setup, IndexGoal::kMap);
    return Done{};
  }

  /// Whether the step that was straightened last still contradicts something.
  bool isInVain(const std::vector<HalfedgeId>& edges) const {
    const TriMesh& mesh = surface_.mesh();
    if (tried_.empty()) return false;
    return std::any_of(edges.begin(), edges.end(), [&](HalfedgeId h) {
      return std::any_of(tried_.back().begin(), tried_.back().end(),
                         [&](HalfedgeId g) { return mesh.edge(g) == mesh.edge(h); });
    });
  }

  std::optional<AlignedField> nextField(const AlignedField& field,
                                        const std::vector<HalfedgeId>& edges) {
    const TriMesh& mesh = surface_.mesh();
    const Geometry& geometry = surface_.context().geometry;
    if (before_ && isInVain(edges))
      --straightened_;
    else
      before_ = field;
    for (const FeatureStep& step : findSteps(mesh, geometry, *before_, edges)) {
      const auto isTried = [&](const std::vector<HalfedgeId>& run) { return run == step.run; };
      if (std::any_of(tried_.begin(), tried_.end(), isTried)) continue;
      tried_.push_back(step.run);
      AlignedField next = withoutStep(mesh, *before_, step);
      if (hasGivenIndices(mesh, next)) return next;
    }
    return {};
  }

  PreparedSurface& surface_;
  const ParametrizeOptions& options_;
  Parametrization& result_;
  std::optional<AlignedField> before_;          ///< without the last step
  std::vector<std::vector<HalfedgeId>> tried_;  ///< runs of steps
  std::optional<StraightSetup> first_;          ///< before any step
  bool isSearched_ = false, isSearchedForMaps_ = false;
  bool isCutShort_ = false;  ///< no rounds were left for the last field
  int contradicting_ = 0, straightened_ = 0, moved_ = 0;
};

/// Rounds after which the cones of a field are doubted, and those that other cones get before the full search.
constexpr int kHurriedRounds = 2;

ParametrizeOptions hurried(ParametrizeOptions options, const Parametrization& result) {
  options.maxRounds = static_cast<int>(result.rounds.size()) + kHurriedRounds;
  return options;
}

bool isSettled(const Result<StraightOutcome>& outcome) {
  return !outcome || outcome->attempt.certificate.isCertified;
}

/// The full search, but where pairs of cones on flat places can be left out, a few rounds with all cones and a few without
/// the pairs come first. Runs with few rounds have none to spare for that.
Result<StraightOutcome> solveFields(PreparedSurface& surface, const ParametrizeOptions& options,
                                    StraightSetup setup, Parametrization& result) {
  const TriMesh& mesh = surface.mesh();
  const Geometry& geometry = surface.context().geometry;
  const auto finish = [](const StepSearch& search, Result<StraightOutcome>& outcome) {
    if (outcome) search.note();
    return std::move(outcome);
  };
  AlignedField fewer = setup.aligned;
  if (options.maxRounds > 2 * kHurriedRounds && cancelFlatPairs(mesh, geometry, fewer) > 0) {
    const ParametrizeOptions few = hurried(options, result);
    StepSearch search(surface, few, result);
    Result<StraightOutcome> outcome = search.run(setup);
    // Lengths that contradict each other are those of corners, which stay without the pairs.
    if (isSettled(outcome) || search.isContradicting()) return finish(search, outcome);
    Result<StraightSetup> other = prepareLengths(surface, setup.seamless.field.spec.features,
                                                 std::move(fewer), options, result.times);
    if (other) {
      const ParametrizeOptions fewMore = hurried(options, result);
      StepSearch without(surface, fewMore, result);
      Result<StraightOutcome> found = without.run(std::move(*other));
      if (isSettled(found)) return finish(without, found);
    }
  }
  StepSearch search(surface, options, result);
  Result<StraightOutcome> outcome = search.run(std::move(setup));
  return finish(search, outcome);
}

/// A certified map is put on the grid that is asked for, and there improved again.
Status alignToLines(const TriMesh& mesh, const ParametrizeOptions& options,
                    const StraightSetup& setup, MappedSolution& mapped, Parametrization& result) {
  StageClock clock(options.progress, result.times);
  if (!clock.begin(Stage::kAlign)) return clock.cancelled();
  StraightGrid grid = alignAlong(mesh, setup, placesOf(mapped.solution),
                                 partsOf(mapped.solution.x, setup.unknowns.variable), options);
  if (grid.isCancelled) return clock.cancelled();
  result.grid = std::move(grid.report);
  if (!grid.attempt) return Done{};
  setParts(grid.attempt->program.x, setup.unknowns.variable, mapped.solution.x);
  mapped.map = std::move(grid.attempt->map);
  mapped.certificate = std::move(grid.attempt->certificate);
  if (!options.improve) return Done{};
  clock.end();
  return improveOnGrid(mesh, options, grid.isHeld, alignmentMultiplyAdds(mesh, result), mapped,
                       result);
}

/// What is asked for after the map: less distortion, a grid.
Status finish(const TriMesh& mesh, const ParametrizeOptions& options, StraightOutcome& outcome,
              Parametrization& result) {
  StraightAttempt& attempt = outcome.attempt;
  if (!attempt.certificate.isCertified) return Done{};
  const StraightSetup& setup = outcome.setup;
  MappedSolution mapped;
  mapped.solution.setup = {std::shared_ptr<const void>(), &setup.seamless};
  mapped.solution.real = &setup.unknowns;
  mapped.solution.x = Eigen::VectorXcd::Zero(setup.seamless.unknowns.count);
  setParts(attempt.program.x, setup.unknowns.variable, mapped.solution.x);
  mapped.map = std::move(attempt.map);
  mapped.certificate = std::move(attempt.certificate);
  Status done = Done{};
  if (options.improve) done = improveSolution(mesh, options, mapped, result);
  if (done && options.grid.isAsked()) done = alignToLines(mesh, options, setup, mapped, result);
  attempt.map = std::move(mapped.map);
  attempt.certificate = std::move(mapped.certificate);
  return done;
}

}  // namespace

Result<Parametrization> parametrizeAlongFeatures(PreparedSurface& surface, const HolonomySpec& spec,
                                                 const ParametrizeOptions& options) {
  if (Status possible = checkOptions(surface, spec, options); !possible)
    return std::move(possible).error();
  const TriMesh& mesh = surface.mesh();
  Parametrization result;
  Result<StraightSetup> setup =
      prepareLengths(surface, withRims(mesh, spec.features), spec, options, result.times);
  if (!setup) return std::move(setup).error();
  Result<StraightOutcome> outcome = solveFields(surface, options, std::move(*setup), result);
  if (!outcome) return std::move(outcome).error();
  const SeamlessSetup& seamless = outcome->setup.seamless;
  result.spec = seamless.field.spec;
  HGP_CHECK(hasGivenIndices(mesh, outcome->setup.aligned), "prescribed cones are those of the map");
  if (Status same = checkTurns(spec, result.spec); !same) return std::move(same).error();
  result.notes.insert(result.notes.begin(), seamless.warnings.begin(), seamless.warnings.end());
  result.copyOf = seamless.cut.parent.raw();
  if (Status done = finish(mesh, options, *outcome, result); !done) return std::move(done).error();
  result.map = std::move(outcome->attempt.map);
  result.certificate = std::move(outcome->attempt.certificate);
  result.isCertified = result.certificate.isCertified;
  result.isUsable = result.certificate.isUsable;
  if (!result.isCertified) result.strained = outcome->attempt.program.conflict;
  return result;
}

Result<int> countConesAlong(PreparedSurface& surface, const HolonomySpec& spec) {
  if (Status possible = checkOptions(surface, spec, {}); !possible) return possible.error();
  const TriMesh& mesh = surface.mesh();
  const std::vector<EdgeId> features = withRims(mesh, spec.features);
  Result<AlignedField> aligned = alignedField(mesh, surface.context(), features, spec);
  if (!aligned) return std::move(aligned).error();
  const CompleteSpec found = specOf(mesh, surface.context().topology, {}, *aligned, features);
  return static_cast<int>(found.cones.size());
}

Status checkAlongFeatures(PreparedSurface& surface, const HolonomySpec& spec) {
  if (Result<int> cones = countConesAlong(surface, spec); !cones) return std::move(cones).error();
  return Done{};
}

}  // namespace hgp
