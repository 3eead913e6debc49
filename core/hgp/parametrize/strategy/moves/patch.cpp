#include <algorithm>

#include "hgp/parametrize/strategy/moves/moves.h"

namespace hgp {
namespace {

/// Rings around the wrong triangles that are solved again; patches are at most this share of the faces.
constexpr int kRings = 6;
constexpr int kWideRings = 24;
constexpr double kLargestShare = 0.25;

/// Empty if the patch would be a large part of the mesh, or if there is no map to supply the held values.
std::vector<FaceId> patchAround(const Problem& problem, const std::vector<FaceId>& faces, int rings,
                                const Attempt& from) {
  if (from.program.x.size() == 0 || !from.program.x.allFinite()) return {};
  std::vector<FaceId> patch = growFaces(problem.mesh, faces, rings);
  if (static_cast<double>(patch.size()) > kLargestShare * problem.mesh.faceCount()) patch.clear();
  return patch;
}

bool isWorse(const State& state, const Attempt& attempt) {
  return !state.patch.empty() && state.from && attempt.wrongCount > state.from->wrongCount;
}

}  // namespace

std::optional<State> solvePatch(const Problem& problem, const State& state,
                                const std::shared_ptr<const Attempt>& attempt) {
  const Weighting& weighting = problem.weightings[state.weighting];
  if (state.untangling >= 0 || weighting.soft == 0.0 || isWorse(state, *attempt)) return {};
  if (attempt->wrong.empty() || !attempt->isFeasible() || state.growth >= weighting.growthRounds)
    return {};
  State next = state;
  next.isWide = state.isWide || !state.patch.empty();  // the narrow patch failed
  const std::vector<FaceId> grown = growFaces(problem.mesh, attempt->wrong, 1);
  next.patch = patchAround(problem, grown, next.isWide ? kWideRings : kRings, *attempt);
  next.hard.clear();
  std::set_union(state.hard.begin(), state.hard.end(), grown.begin(), grown.end(),
                 std::back_inserter(next.hard));
  // Without a patch, no more triangles are constrained than by the next weighting.
  if (next.patch.empty() &&
      (next.hard.size() == state.hard.size() || next.hard.size() > problem.base.size()))
    return {};
  next.from = attempt;
  ++next.growth;
  return next;
}

std::optional<State> widenPatch(const Problem& problem, const State& state,
                                const std::shared_ptr<const Attempt>& attempt) {
  if (state.untangling >= 0 || state.isWide || !isWorse(state, *attempt)) return {};
  State next = state;
  next.isWide = true;
  next.patch =
      patchAround(problem, growFaces(problem.mesh, state.from->wrong, 1), kWideRings, *state.from);
  if (next.patch.empty()) return {};
  return next;
}

}  // namespace hgp
