#include "hgp/parametrize/strategy/moves/moves.h"

namespace hgp {

std::optional<State> nextWeighting(const Problem& problem, const State& state,
                                   const std::shared_ptr<const Attempt>& attempt) {
  std::size_t weighting = state.weighting + 1;
  if (weighting < problem.weightings.size() && !attempt->certificate.isCertified &&
      problem.weightings[weighting].rows == WeightKind::kCotangent)
    ++weighting;
  if (weighting >= problem.weightings.size()) return {};
  State next = startOf(problem, weighting);
  next.untangled = state.untangled;
  next.from = attempt->isFeasible() && state.untangling < 0 ? attempt : state.from;
  return next;
}

}  // namespace hgp
