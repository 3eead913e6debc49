#include "hgp/parametrize/parametrize.h"

#include <algorithm>

#include "hgp/parametrize/stage_clock.h"
#include "hgp/parametrize/strategy/loop.h"
#include "hgp/parametrize/strategy/state.h"

namespace hgp {
namespace {

/// Longest edge over height: above it a triangle is very thin.
constexpr double kVeryThin = 30.0;
/// A surface with at least this share of very thin triangles is uneven.
constexpr double kUnevenShare = 0.1;
/// Rounds in its own metric before an uneven surface is tried in the evened one. (Other surfaces are not tried there:
/// of 38 without a map, the evened metric gave one for 2, at twice the time.)
constexpr int kUnevenRounds = 8;

/// Iterations per triangle with one choice of the handles' rotations while there are others, enough for two or three
/// untanglings; with each of these; their number; and iterations × triangles with all of them, about ten seconds.
constexpr double kStepsOfHandles = 350.0;
constexpr double kStepsOfOthers = 230.0;
constexpr int kMaxHandles = 8;
constexpr double kMaxHandleSteps = 6e6;

bool isUneven(const TriMesh& mesh, const Geometry& geometry) {
  const auto isThin = [&](FaceId f) {
    double longest = 0.0;
    for (int k = 0; k < 3; ++k)
      longest = std::max(longest, geometry.length[TriMesh::halfedge(f, k)]);
    return longest * longest > kVeryThin * 2.0 * geometry.area[f];
  };
  int count = 0;
  for (FaceId f : mesh.faces()) count += isThin(f);
  return count >= kUnevenShare * mesh.faceCount();
}

/// The options with the steps that remain of the run's limit.
ParametrizeOptions remaining(const ParametrizeOptions& options, const std::vector<Round>& rounds,
                             int faceCount) {
  ParametrizeOptions left = options;
  left.maxRounds -= static_cast<int>(rounds.size());
  for (const Round& round : rounds)
    left.maxStepsPerFace -=
        faceStepsOf(round, faceCount) / std::max(faceCount, ParametrizeOptions::kSmallSurface);
  return left;
}

template <class T>
void prepend(std::vector<T>& later, const std::vector<T>& earlier) {
  later.insert(later.begin(), earlier.begin(), earlier.end());
}

/// Solves in the evened metric after the surface's own gave no map; if that fails as well, returns the earlier result.
Result<Parametrization> inEvenedMetric(PreparedSurface& surface, const HolonomySpec& spec,
                                       const ParametrizeOptions& options, Parametrization before) {
  const ParametrizeOptions left = remaining(options, before.rounds, surface.mesh().faceCount());
  if (left.maxRounds <= 0 || left.maxStepsPerFace <= 0.0) return before;
  Result<Parametrization> run = parametrizeInMetric(surface.evened(), spec, left);
  if (!run) return run;
  for (Round& round : run->rounds) round.method = "evened lengths: " + round.method;
  prepend(run->rounds, before.rounds);
  prepend(run->times, before.times);
  if (run->isCertified) {
    run->notes.emplace_back("map-evened-lengths");
    return run;
  }
  before.rounds = std::move(run->rounds);
  before.times = std::move(run->times);
  return before;
}

/// In the surface's own metric and, where that is uneven, in the evened one.
Result<Parametrization> inEitherMetric(PreparedSurface& surface, const HolonomySpec& spec,
                                       const ParametrizeOptions& options, bool mayEven) {
  if (!mayEven) return parametrizeInMetric(surface, spec, options);
  ParametrizeOptions first = options;
  first.maxRounds = std::min(options.maxRounds, kUnevenRounds);
  Result<Parametrization> run = parametrizeInMetric(surface, spec, first);
  if (!run || run->isCertified || run->isImpossible) return run;
  return inEvenedMetric(surface, spec, options, std::move(*run));
}

bool hasOpenHandles(const PreparedSurface& surface, const HolonomySpec& spec) {
  const auto isOpen = [](const std::optional<int>& r) { return !r; };
  return surface.topology().genus > 0 && spec.features.empty() &&
         (spec.handles.empty() || std::any_of(spec.handles.begin(), spec.handles.end(), isOpen));
}

double faceStepsOf(const std::vector<Round>& rounds, int faceCount) {
  double sum = 0.0;
  for (const Round& round : rounds) sum += hgp::faceStepsOf(round, faceCount);
  return sum;
}

/// The options with at most so many steps per triangle.
ParametrizeOptions within(const ParametrizeOptions& options, double stepsPerFace, int faceCount) {
  ParametrizeOptions out = options;
  const double share =
      stepsPerFace * faceCount / std::max(faceCount, ParametrizeOptions::kSmallSurface);
  out.maxStepsPerFace = std::min(options.maxStepsPerFace, share);
  return out;
}

/// Tries other rotations of the handles that the prescription leaves open. Returns `before`, with the rounds of all,
/// where none has a map.
Result<Parametrization> withOtherHandles(PreparedSurface& surface, const HolonomySpec& spec,
                                         const ParametrizeOptions& options,
                                         Parametrization before) {
  if (Status done = surface.requireConnection(); !done) return before;
  const int faceCount = surface.mesh().faceCount();
  const ParametrizeOptions few = within(options, kStepsOfOthers, faceCount);
  int tried = 0;
  double steps = 0.0;
  for (const std::vector<int>& handles :
       otherHandles(surface.mesh(), surface.context(), spec, before.spec)) {
    if (tried++ == kMaxHandles || steps > kMaxHandleSteps) break;
    HolonomySpec other = spec;
    other.turning.assign(before.spec.turning.begin(), before.spec.turning.end());
    other.handles.assign(handles.begin(), handles.end());
    Result<Parametrization> run = parametrizeInMetric(surface, other, few);
    if (!run) return run;
    steps += faceStepsOf(run->rounds, faceCount);
    for (Round& round : run->rounds) round.method = "other handles: " + round.method;
    prepend(run->rounds, before.rounds);
    prepend(run->times, before.times);
    if (run->isCertified) return run;
    before.rounds = std::move(run->rounds);
    before.times = std::move(run->times);
  }
  return before;
}

}  // namespace

Result<Parametrization> parametrize(PreparedSurface& surface, const HolonomySpec& spec,
                                    const ParametrizeOptions& options) {
  const int faceCount = surface.mesh().faceCount();
  const bool isFree = options.method == Method::kAuto && !options.frames;
  const bool mayEven = isFree && isUneven(surface.mesh(), surface.context().ownGeometry());
  const bool mayTurn = isFree && hasOpenHandles(surface, spec);
  // What a few untanglings do not solve, other handles mostly do, and sooner than more untanglings.
  const bool isCut = mayTurn && !mayEven;
  std::shared_ptr<PausedSearch> paused;
  Result<Parametrization> run =
      isCut
          ? parametrizeInMetric(surface, spec, within(options, kStepsOfHandles, faceCount), &paused)
          : inEitherMetric(surface, spec, options, mayEven);
  if (!mayTurn || !run || run->isCertified || run->isImpossible) return run;
  run = withOtherHandles(surface, spec, options, std::move(*run));
  if (!paused || !run || run->isCertified) return run;
  Result<Parametrization> whole = parametrizeInMetric(surface, spec, options, &paused);
  if (!whole) return whole;
  prepend(whole->rounds, run->rounds);
  prepend(whole->times, run->times);
  return whole;
}

Result<Parametrization> parametrize(const TriMesh& mesh, const HolonomySpec& spec,
                                    const ParametrizeOptions& options) {
  std::vector<StageTime> times;
  StageClock clock(options.progress, times);
  if (!clock.begin(Stage::kPrepare)) return clock.cancelled();
  PreparedSurface surface(mesh);
  clock.end();
  Result<Parametrization> result = parametrize(surface, spec, options);
  if (result) result->times.insert(result->times.begin(), times.begin(), times.end());
  return result;
}

}  // namespace hgp
