#include <algorithm>

#include "hgp/parametrize/moves/moves.h"

namespace hgp {
namespace {

/// So much of F_cb stays constrained, whatever contradicts it.
constexpr double kLeastShare = 0.5;

}  // namespace

std::optional<State> turnEvenly(const Problem& problem, const State& state,
                                const std::shared_ptr<const Attempt>& attempt) {
  if (state.untangling >= 0 || state.isEven || attempt->isFeasible()) return {};
  State next = startOf(problem, state.weighting);
  next.isEven = true;
  next.takenBack = state.takenBack;
  next.from = state.from;
  return next;
}

std::optional<State> dropFrames(const Problem& problem, const State& state,
                                const std::shared_ptr<const Attempt>& attempt) {
  if (state.untangling >= 0 || attempt->isFeasible()) return {};
  std::vector<FaceId> dropped = attempt->program.conflict;
  std::sort(dropped.begin(), dropped.end());
  State next = state;
  next.patch.clear();
  std::erase_if(next.hard,
                [&](FaceId f) { return std::binary_search(dropped.begin(), dropped.end(), f); });
  const double least = kLeastShare * static_cast<double>(problem.base.size());
  if (next.hard.size() == state.hard.size() || static_cast<double>(next.hard.size()) < least)
    return {};
  return next;
}

}  // namespace hgp
