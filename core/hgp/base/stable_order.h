// The order of things that are not moved themselves.  Role: one sort for all that are sorted by index.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace hgp {

/// The numbers below `count`, sorted; of two of which neither is before the other, the lower one comes first.
std::vector<std::size_t> stableOrder(std::size_t count,
                                     const std::function<bool(std::size_t, std::size_t)>& isBefore);

/// std::stable_sort for lists that are short beside what is done with them: one sort for all types.
template <class T, class Less>
void sortStably(std::vector<T>& list, const Less& less) {
  const std::vector<std::size_t> order = stableOrder(
      list.size(), [&](std::size_t a, std::size_t b) { return less(list[a], list[b]); });
  std::vector<T> sorted;
  sorted.reserve(list.size());
  for (const std::size_t i : order) sorted.push_back(std::move(list[i]));
  list = std::move(sorted);
}

/// std::sort for three, which needs no more code than this.
template <class T, class Less>
void sortThree(std::array<T, 3>& list, const Less& less) {
  const auto order = [&](T& first, T& second) {
    if (less(second, first)) std::swap(first, second);
  };
  order(list[0], list[1]);
  order(list[1], list[2]);
  order(list[0], list[1]);
}

}  // namespace hgp
