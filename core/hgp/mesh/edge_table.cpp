#include "hgp/mesh/edge_table.h"

#include <algorithm>
#include <numeric>

#include "hgp/base/ids.h"

namespace hgp {

EdgeTable::EdgeTable(const std::vector<std::array<int, 3>>& triangles,
                     const std::vector<char>& isSkipped, int vertexCount) {
  const int sideCount = static_cast<int>(3 * triangles.size());
  struct Entry {
    int high, side;
  };
  // Counting sort by the smaller vertex, then each short bucket by the larger one.
  std::vector<int> bucket(at(vertexCount) + 1, 0);
  const auto low = [&](int s) {
    return std::min(sideTail(triangles, s), sideTail(triangles, nextSide(s)));
  };
  const auto high = [&](int s) {
    return std::max(sideTail(triangles, s), sideTail(triangles, nextSide(s)));
  };
  for (int s = 0; s < sideCount; ++s)
    if (!isSkipped[at(s / 3)]) ++bucket[at(low(s)) + 1];
  std::partial_sum(bucket.begin(), bucket.end(), bucket.begin());
  std::vector<Entry> entries(at(bucket.back()));
  std::vector<int> fill(bucket.begin(), bucket.end() - 1);
  for (int s = 0; s < sideCount; ++s)
    if (!isSkipped[at(s / 3)]) entries[at(fill[at(low(s))]++)] = {high(s), s};

  sides_.resize(entries.size());
  start_.reserve(entries.size() / 2 + 2);
  vertices_.reserve(entries.size() / 2 + 1);
  for (int v = 0; v < vertexCount; ++v) {
    const auto first = entries.begin() + bucket[at(v)], last = entries.begin() + bucket[at(v) + 1];
    std::sort(first, last, [](const Entry& a, const Entry& b) {
      return a.high != b.high ? a.high < b.high : a.side < b.side;
    });
    for (auto e = first; e != last; ++e) {
      const auto n = static_cast<int>(e - entries.begin());
      if (e == first || e->high != (e - 1)->high) {
        start_.push_back(n);
        vertices_.push_back({v, e->high});
      }
      sides_[at(n)] = e->side;
    }
  }
  start_.push_back(static_cast<int>(entries.size()));
}

}  // namespace hgp
