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

/// The options with the work that remains of the run's limit.
ParametrizeOptions remaining(const ParametrizeOptions& options, const std::vector<Round>& rounds,
                             int faceCount) {
  ParametrizeOptions left = options;
  left.maxRounds -= static_cast<int>(rounds.size());
  for (const Round& round : rounds)
    left.largestWork -=
        workOf(round, faceCount) / std::max(faceCount, ParametrizeOptions::kSmallSurface);
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
  if (left.maxRounds <= 0 || left.largestWork <= 0.0) return before;
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

}  // namespace

Result<Parametrization> parametrize(PreparedSurface& surface, const HolonomySpec& spec,
                                    const ParametrizeOptions& options) {
  const bool mayEven = options.method == Method::kAuto && !options.frames &&
                       isUneven(surface.mesh(), surface.context().ownGeometry());
  if (!mayEven) return parametrizeInMetric(surface, spec, options);
  ParametrizeOptions first = options;
  first.maxRounds = std::min(options.maxRounds, kUnevenRounds);
  Result<Parametrization> run = parametrizeInMetric(surface, spec, first);
  if (!run || run->isCertified || run->isImpossible) return run;
  return inEvenedMetric(surface, spec, options, std::move(*run));
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
