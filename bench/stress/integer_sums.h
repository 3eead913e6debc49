// Uniformly distributed integer vectors with a given sum.  Role: cone indices that satisfy Gauss–Bonnet, all equally
// likely.
#pragma once

#include <optional>
#include <vector>

#include "random.h"

namespace hgp::stress {

/// The allowed values of one entry: low … high except `hole`.
struct IntegerRange {
  int low = 0, high = 0;
  std::optional<int> hole;
};

/// x with x_i in ranges[i] and Σ x_i = sum, uniform over all such x (the numbers of completions are
/// counted from the back); empty if there is none.
std::optional<std::vector<int>> drawWithSum(const std::vector<IntegerRange>& ranges, int sum,
                                            Random& random);

}  // namespace hgp::stress
