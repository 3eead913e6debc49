// Disjoint sets of the numbers 0 … n − 1.  Role: used for components, fans, forests and merged vertices.
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace hgp {

/// Union–find with path halving; the smallest member is the root of its set.
class DisjointSets {
 public:
  explicit DisjointSets(int count) : parent_(static_cast<std::size_t>(count)) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  int root(int a) {
    while (parent(a) != a) a = parent(a) = parent(parent(a));
    return a;
  }
  /// False if a and b were already in one set.
  bool join(int a, int b) {
    a = root(a);
    b = root(b);
    if (a == b) return false;
    parent(std::max(a, b)) = std::min(a, b);
    return true;
  }

 private:
  int& parent(int a) { return parent_[static_cast<std::size_t>(a)]; }
  std::vector<int> parent_;
};

}  // namespace hgp
