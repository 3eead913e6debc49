#include "hgp/parametrize/along/along_features.h"

#include <algorithm>
#include <chrono>

#include "hgp/base/counted.h"
#include "hgp/features/field_along.h"
#include "hgp/features/step_repair.h"
#include "hgp/mesh/face_rings.h"
#include "hgp/parametrize/along/straight_setup.h"
#include "hgp/parametrize/stage_clock.h"

namespace hgp {
namespace {

using Clock = std::chrono::steady_clock;
double elapsedSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// How the programs of one pass are weighted: the scale e^{share·u}, and δ.
struct StraightWeighting {
  const char* name;
  double share;
  double quality;
};
constexpr StraightWeighting kWeightings[] = {{"straight features", 1.0, 1e-4},
                                             {"straight features, even weights", 0.0, 1e-4},
                                             {"straight features, light distortion", 1.0, 1e-2}};
/// Enlargements of the constrained set for each of them.
constexpr int kGrowthRounds = 3;
/// Steps that are straightened at most, because lengths contradict each other.
constexpr int kMostSteps = 8;

struct StraightAttempt {
  StraightResult program;
  UvMap map;
  Certificate certificate;
  std::vector<FaceId> wrong;  ///< not positive, or at a vertex or loop with a wrong angle
  int wrongCount = 0;
};

Failure refusal(std::string message) {
  return {ErrorCode::kUsage, "features", std::move(message), {}};
}

Status checkOptions(const HolonomySpec& spec, const ParametrizeOptions& options) {
  if (spec.q != 4)
    return refusal("features need q = 4; these cones have q = " + std::to_string(spec.q) + ".");
  if (options.frames) return refusal("Frames of a file do not go with features; leave out either.");
  if (options.grid.isAsked())
    return refusal("A grid does not go with features yet; leave out either.");
  if (options.improve)
    return refusal("An improvement does not go with features yet; leave out either.");
  return Done{};
}

bool isAnyOther(const std::vector<std::optional<int>>& asked, const std::vector<int>& found) {
  for (std::size_t i = 0; i < asked.size() && i < found.size(); ++i)
    if (asked[i] && *asked[i] != found[i]) return true;
  return false;
}

/// What is prescribed beside features must be what the aligned field has.
Status checkCones(const HolonomySpec& asked, const CompleteSpec& found) {
  if (isAnyOther(asked.turning, found.turning) || isAnyOther(asked.handles, found.handles))
    return Failure{ErrorCode::kPrescription,
                   "features",
                   "With features, turnings and rotations along handles are those of a field along "
                   "them, which are not the prescribed ones. Leave out these or the features.",
                   {}};
  if (asked.cones.empty()) return Done{};
  std::vector<Where> where;
  const auto isIn = [](const std::vector<ConePoint>& list, const ConePoint& cone) {
    return std::any_of(list.begin(), list.end(), [&](const ConePoint& other) {
      return other.vertex == cone.vertex && other.k == cone.k;
    });
  };
  for (const ConePoint& cone : asked.cones)
    if (cone.k != asked.q && !isIn(found.cones, cone))
      where.push_back({Where::Kind::kVertex, cone.vertex.i});
  for (const ConePoint& cone : found.cones)
    if (!isIn(asked.cones, cone)) where.push_back({Where::Kind::kVertex, cone.vertex.i});
  if (where.empty()) return Done{};
  return Failure{ErrorCode::kPrescription, "features",
                 "With features, cones are those of a field along them; " +
                     counted(where.size(), "cone differs", "cones differ") +
                     " from the prescribed ones. Leave out the cones or the features.",
                 std::move(where)};
}

void findWrong(const TriMesh& mesh, const Topology& topology, StraightAttempt& attempt) {
  const Certificate& c = attempt.certificate;
  if (!c.isMeasured) {
    attempt.wrongCount = 1 << 30;
    return;
  }
  attempt.wrong = c.orientation.notPositive;
  attempt.wrongCount = static_cast<int>(attempt.wrong.size() + c.angles.wrong.size());
  const auto addRing = [&](VertexId v) {
    for (HalfedgeId h : outgoingHalfedges(mesh, v)) attempt.wrong.push_back(TriMesh::face(h));
  };
  for (const MeasuredCone& cone : c.angles.wrong) addRing(cone.vertex);
  for (const MeasuredTurning& turning : c.angles.turnings) {
    if (!turning.isWrong) continue;
    ++attempt.wrongCount;
    for (HalfedgeId h : topology.loops[at(turning.loop.i)].halfedges) addRing(mesh.tail(h));
  }
  std::sort(attempt.wrong.begin(), attempt.wrong.end());
  attempt.wrong.erase(std::unique(attempt.wrong.begin(), attempt.wrong.end()), attempt.wrong.end());
}

class StraightRun {
 public:
  StraightRun(const TriMesh& mesh, const StraightSetup& setup, const ParametrizeOptions& options,
              std::vector<Round>& rounds)
      : mesh_(mesh), setup_(setup), options_(options), rounds_(rounds), verifier_(mesh) {}

  /// The first certified map, or the one that is nearest to it. Nothing if it was cancelled.
  std::optional<StraightAttempt> run() {
    for (const StraightWeighting& weighting : kWeightings) {
      std::vector<FaceId> hard = setup_.base;
      for (int growth = 0; growth <= kGrowthRounds; ++growth) {
        if (static_cast<int>(rounds_.size()) >= options_.maxRounds) return std::move(best_);
        StraightAttempt attempt = solve(weighting, growth, hard);
        if (isCancelled_) return {};
        const std::vector<FaceId> wrong = attempt.wrong;
        const bool isInfeasible = socp::isWithoutPoint(attempt.program.status);
        if (!best_ || attempt.certificate.isCertified || attempt.wrongCount < best_->wrongCount)
          best_ = std::move(attempt);
        if (best_->certificate.isCertified) return std::move(best_);
        if (isInfeasible && growth == 0 && !findShort(weighting)) return std::move(best_);
        if (isInfeasible || wrong.empty()) break;
        const std::vector<FaceId> more = growFaces(mesh_, wrong, 1);
        const std::size_t before = hard.size();
        hard.insert(hard.end(), more.begin(), more.end());
        std::sort(hard.begin(), hard.end());
        hard.erase(std::unique(hard.begin(), hard.end()), hard.end());
        if (hard.size() == before) break;
      }
    }
    return std::move(best_);
  }

  /// Edges whose lengths alone contradict each other, with frames left out; empty where they do not.
  const std::vector<HalfedgeId>& shortEdges() const { return short_; }

 private:
  /// Looks whether the lengths of feature edges contradict each other; false if that is so, or if it was cancelled.
  bool findShort(const StraightWeighting& weighting) {
    const StraightOptions program = optionsOf(weighting);
    const SeamlessSystem system = systemOf(mesh_, setup_.seamless);
    const StraightResult lengths = solveStraight(straightSystemOf(setup_, system), {}, program);
    if (socp::isWithoutPoint(lengths.status)) short_ = lengths.conflictEdges;
    return short_.empty() && !isCancelled_;
  }

  StraightOptions optionsOf(const StraightWeighting& weighting) {
    StraightOptions program;
    program.u = setup_.seamless.field.u;
    for (double& u : program.u.raw()) u *= weighting.share;
    program.quality = weighting.quality;
    const int round = static_cast<int>(rounds_.size()) + 1;
    program.progress = [this, round](int iteration, double residual) {
      const double fraction = 1.0 - 1.0 / (1.0 + 0.25 * iteration);
      isCancelled_ = !report(options_.progress, {Stage::kSolve, fraction, iteration, residual,
                                                 round, options_.maxRounds});
      return !isCancelled_;
    };
    return program;
  }

  StraightAttempt solve(const StraightWeighting& weighting, int growth,
                        const std::vector<FaceId>& hard) {
    const auto start = Clock::now();
    const SeamlessSetup& seamless = setup_.seamless;
    const StraightOptions program = optionsOf(weighting);
    const SeamlessSystem system = systemOf(mesh_, seamless);
    StraightAttempt attempt;
    attempt.program =
        solveStraight(straightSystemOf(setup_, system), fieldFrames(seamless.seams, hard), program);
    attempt.map = layOut(mesh_, seamless, attempt.program.z);
    attempt.certificate = verifier_.certify(toSpec(seamless.field.spec), attempt.map);
    findWrong(mesh_, seamless.context->topology, attempt);
    record(weighting, growth, hard.size(), attempt, elapsedSince(start));
    return attempt;
  }

  void record(const StraightWeighting& weighting, int growth, std::size_t hardCount,
              const StraightAttempt& attempt, double seconds) {
    Round round;
    round.method = weighting.name;
    if (growth > 0) round.method += " + enlarged " + std::to_string(growth);
    round.constrainedTriangles = static_cast<int>(hardCount);
    round.iterations = attempt.program.iterations;
    round.solverStatus = socp::statusName(attempt.program.status);
    round.flipped = attempt.certificate.orientation.zero + attempt.certificate.orientation.negative;
    round.wrongAngles = static_cast<int>(attempt.certificate.angles.wrong.size());
    for (const MeasuredTurning& t : attempt.certificate.angles.turnings)
      round.wrongAngles += t.isWrong;
    round.laplacianEnergy = attempt.program.laplacianEnergy;
    round.work = attempt.program.work;
    round.seconds = seconds;
    rounds_.push_back(round);
  }

  const TriMesh& mesh_;
  const StraightSetup& setup_;
  const ParametrizeOptions& options_;
  std::vector<Round>& rounds_;
  Verifier verifier_;
  std::optional<StraightAttempt> best_;
  std::vector<HalfedgeId> short_;
  bool isCancelled_ = false;
};

/// The given features and all boundary edges, ascending.
std::vector<EdgeId> withRims(const TriMesh& mesh, std::vector<EdgeId> features) {
  for (EdgeId e : mesh.edges())
    if (mesh.isBoundary(mesh.halfedge(e))) features.push_back(e);
  std::sort(features.begin(), features.end());
  features.erase(std::unique(features.begin(), features.end()), features.end());
  return features;
}

}  // namespace

namespace {

/// What the programs of one field led to.
struct StraightOutcome {
  StraightSetup setup;
  StraightAttempt attempt;
};

/// Solves along one field after another: where lengths contradict each other, the shortest step among the contradicting
/// edges is straightened, and where that does not help, the next one.
class StepSearch {
 public:
  StepSearch(PreparedSurface& surface, const ParametrizeOptions& options, Parametrization& result)
      : surface_(surface), options_(options), result_(result) {}

  Result<StraightOutcome> run(StraightSetup setup) {
    for (;;) {
      const auto start = Clock::now();
      StraightRun run(surface_.mesh(), setup, options_, result_.rounds);
      std::optional<StraightAttempt> attempt = run.run();
      result_.times.push_back({Stage::kSolve, elapsedSince(start)});
      if (!attempt) return cancelled(Stage::kSolve);
      const std::vector<HalfedgeId> edges = run.shortEdges();
      contradicting_ = static_cast<int>(edges.size());
      StraightOutcome outcome{std::move(setup), std::move(*attempt)};
      if (edges.empty() || static_cast<int>(tried_.size()) == kMostSteps) return outcome;
      std::optional<AlignedField> next = nextField(outcome.setup.aligned, edges);
      if (!next) return outcome;
      Result<StraightSetup> again =
          prepareStraight(surface_, outcome.setup.seamless.field.spec.features, std::move(*next),
                          options_, result_.times);
      if (!again) return outcome;
      setup = std::move(*again);
      ++straightened_;
    }
  }

  void note() const {
    if (contradicting_ > 0)
      result_.notes.push_back(
          "The lengths of features contradict each other: " +
          counted(contradicting_, "feature edge") +
          " would have no length, whatever the map (see conflict). Leave out one of these.");
    if (straightened_ > 0 && contradicting_ == 0)
      result_.notes.push_back(counted(straightened_, "step") +
                              " of features would have no length, because the lines around allow "
                              "none; the map goes straight on there.");
  }

 private:
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
      return withoutStep(mesh, geometry, *before_, step);
    }
    return {};
  }

  PreparedSurface& surface_;
  const ParametrizeOptions& options_;
  Parametrization& result_;
  std::optional<AlignedField> before_;          ///< without the last step
  std::vector<std::vector<HalfedgeId>> tried_;  ///< runs of steps
  int contradicting_ = 0, straightened_ = 0;
};

}  // namespace

Result<Parametrization> parametrizeAlongFeatures(PreparedSurface& surface, const HolonomySpec& spec,
                                                 const ParametrizeOptions& options) {
  if (Status possible = checkOptions(spec, options); !possible) return std::move(possible).error();
  const TriMesh& mesh = surface.mesh();
  Parametrization result;
  Result<StraightSetup> setup =
      prepareStraight(surface, withRims(mesh, spec.features), options, result.times);
  if (!setup) return std::move(setup).error();
  StepSearch search(surface, options, result);
  Result<StraightOutcome> outcome = search.run(std::move(*setup));
  if (!outcome) return std::move(outcome).error();
  const SeamlessSetup& seamless = outcome->setup.seamless;
  result.spec = seamless.field.spec;
  if (Status same = checkCones(spec, result.spec); !same) return std::move(same).error();
  result.notes = seamless.warnings;
  search.note();
  result.copyOf = seamless.cut.parent.raw();
  result.map = std::move(outcome->attempt.map);
  result.certificate = std::move(outcome->attempt.certificate);
  result.isCertified = result.certificate.isCertified;
  result.isUsable = result.certificate.isUsable;
  if (!result.isCertified) result.strained = outcome->attempt.program.conflict;
  return result;
}

Status checkAlongFeatures(PreparedSurface& surface, const HolonomySpec& spec) {
  if (Status possible = checkOptions(spec, {}); !possible) return possible;
  const TriMesh& mesh = surface.mesh();
  Result<AlignedField> aligned =
      alignedField(mesh, surface.context(), withRims(mesh, spec.features));
  if (!aligned) return std::move(aligned).error();
  return Done{};
}

}  // namespace hgp
