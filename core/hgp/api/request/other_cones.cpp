#include "hgp/api/request/other_cones.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>

#include "hgp/base/stable_order.h"

namespace hgp::api {
namespace {

/// By number of cones.
constexpr ConesFor kByNumber[] = {ConesFor::kFew, ConesFor::kFewer, ConesFor::kBalanced,
                                  ConesFor::kMore, ConesFor::kLowDistortion};

/// The other purposes, nearest first; of two equally near ones that with more cones, which turn by less each.
std::vector<ConesFor> othersThan(ConesFor purpose) {
  const auto rankOf = [](ConesFor of) {
    return static_cast<int>(std::find(std::begin(kByNumber), std::end(kByNumber), of) -
                            std::begin(kByNumber));
  };
  std::vector<ConesFor> others;
  for (ConesFor other : kByNumber)
    if (other != purpose) others.push_back(other);
  sortStably(others, [&](ConesFor a, ConesFor b) {
    const int toA = rankOf(a) - rankOf(purpose), toB = rankOf(b) - rankOf(purpose);
    return std::abs(toA) != std::abs(toB) ? std::abs(toA) < std::abs(toB) : toA > toB;
  });
  return others;
}

}  // namespace

Status mapWithOtherCones(const SolveOptions& options, const SolveFor& solve,
                         Result<Parametrization>& run, Notes& notes) {
  if (!run || run->isCertified || options.coneCount > 0 || options.alignToCurvature) return Done{};
  Notes before = notes;
  for (ConesFor purpose : othersThan(options.conesFor)) {
    Result<Parametrization> other = solve(purpose);
    if (!other && other.error().code == ErrorCode::kCancelled) return other.error();
    if (!other || !other->isCertified) continue;
    notes.push_back(Note("cones-other", {{"purpose", conesForName(purpose)}}));
    run = std::move(other);
    return Done{};
  }
  notes = std::move(before);
  return Done{};
}

}  // namespace hgp::api
