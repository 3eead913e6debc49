#include "hgp/parametrize/strategy/moves/moves.h"

namespace hgp {

std::optional<State> nextWeighting(const Problem& problem, const State& state,
                                   const std::shared_ptr<const Attempt>& attempt) {
  if (state.weighting + 1 >= problem.weightings.size()) return {};
  State next = startOf(problem, state.weighting + 1);
  next.untangled = state.untangled;
  next.from = attempt->isFeasible() && state.untangling < 0 ? attempt : state.from;
  return next;
}

}  // namespace hgp
