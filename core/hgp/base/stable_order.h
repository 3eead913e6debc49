// The order of things that are not moved themselves.  Role: one sort for all that are sorted by index.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace hgp {

/// The numbers below `count`, sorted; of two of which neither is before the other, the lower one comes first.
std::vector<std::size_t> stableOrder(std::size_t count,
                                     const std::function<bool(std::size_t, std::size_t)>& isBefore);

}  // namespace hgp
