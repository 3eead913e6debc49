#include <algorithm>

#include "hgp/parametrize/strategy/moves/moves.h"

namespace hgp {
namespace {

/// This many triangles may be constrained on any mesh: such a program takes seconds. On
/// larger meshes a quarter of the triangles may be constrained.
constexpr int kAlwaysAllowed = 6000;

}  // namespace

std::optional<State> enlarge(const Problem& problem, const State& state,
                             const std::shared_ptr<const Attempt>& attempt) {
  const Weighting& weighting = problem.weightings[state.weighting];
  if (state.untangling >= 0 || weighting.soft > 0.0 || attempt->wrong.empty()) return {};
  if (!attempt->isFeasible() || state.growth >= weighting.growthRounds) return {};
  const std::vector<FaceId> grown = growFaces(problem.mesh, attempt->wrong, 1);
  State next = state;
  next.hard.clear();
  std::set_union(state.hard.begin(), state.hard.end(), grown.begin(), grown.end(),
                 std::back_inserter(next.hard));
  const std::size_t limit = std::max<std::size_t>(
      static_cast<std::size_t>(problem.mesh.faceCount()) / 4 + problem.base.size(), kAlwaysAllowed);
  if (next.hard.size() == state.hard.size() || next.hard.size() > limit) return {};
  next.from = attempt;
  ++next.growth;
  return next;
}

}  // namespace hgp
