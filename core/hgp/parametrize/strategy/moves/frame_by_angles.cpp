#include "hgp/parametrize/strategy/moves/moves.h"

namespace hgp {

std::optional<State> frameByAngles(const Problem& problem, const State& state,
                                   const std::shared_ptr<const Attempt>&) {
  if (problem.method == Method::kPrinted || state.untangling >= 0 ||
      problem.weightings[state.weighting].soft > 0.0 ||
      problem.weightings[state.weighting].isHarmonic)
    return {};
  if (state.framedBy != FramedBy::kConnection || state.growth > 0 || state.directions) return {};
  State next = startOf(problem, state.weighting);
  next.frames = problem.angles->get(problem.mesh, *problem.setup);
  if (!next.frames) return {};
  next.framedBy = FramedBy::kAngles;
  next.untangled = state.untangled;
  next.from = state.from;
  return next;
}

}  // namespace hgp
