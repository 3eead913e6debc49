#include "hgp/base/stable_order.h"

#include <algorithm>
#include <numeric>

namespace hgp {

std::vector<std::size_t> stableOrder(
    std::size_t count, const std::function<bool(std::size_t, std::size_t)>& isBefore) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return isBefore(a, b); });
  return order;
}

}  // namespace hgp
