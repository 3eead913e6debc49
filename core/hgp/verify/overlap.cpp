#include "hgp/verify/overlap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace hgp {
namespace {

using Triangle = std::array<Vec2, 3>;

std::optional<Triangle> triangleOf(const UvMap& map, const std::array<int, 3>& corners) {
  Triangle t;
  for (std::size_t k = 0; k < 3; ++k) {
    if (corners[k] < 0 || static_cast<std::size_t>(corners[k]) >= map.uv.size()) return {};
    t[k] = map.uv[static_cast<std::size_t>(corners[k])];
    if (!std::isfinite(t[k][0]) || !std::isfinite(t[k][1])) return {};
  }
  return t;
}

struct Square {
  Vec2 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Vec2 high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
};

Square boundsOf(const UvMap& map) {
  Square box;
  for (const auto& corners : map.cornerUv) {
    const auto t = triangleOf(map, corners);
    if (!t) continue;
    for (const Vec2& p : *t) {
      for (std::size_t axis = 0; axis < 2; ++axis) {
        box.low[axis] = std::min(box.low[axis], p[axis]);
        box.high[axis] = std::max(box.high[axis], p[axis]);
      }
    }
  }
  return box;
}

class Grid {
 public:
  explicit Grid(int size)
      : size_(size), counts_(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), 0) {}

  /// In units of cells. Half-open rows and columns: neighbours share no centre.
  void add(const Triangle& t) {
    const auto [low, high] = std::minmax({t[0][1], t[1][1], t[2][1]});
    for (int row = first(low); row < first(high); ++row) {
      double from = size_, to = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto x = crossing(t[k], t[(k + 1) % 3], row + 0.5);
        if (!x) continue;
        from = std::min(from, *x);
        to = std::max(to, *x);
      }
      for (int column = first(from); column < first(to); ++column) {
        ++counts_[static_cast<std::size_t>(row) * static_cast<std::size_t>(size_) +
                  static_cast<std::size_t>(column)];
      }
    }
  }

  OverlapFacts facts() const {
    OverlapFacts facts;
    long long covered = 0, twice = 0;
    for (int count : counts_) {
      covered += count > 0;
      twice += count > 1;
      facts.layers = std::max(facts.layers, count);
    }
    if (covered > 0) facts.share = static_cast<double>(twice) / static_cast<double>(covered);
    return facts;
  }

 private:
  /// The first cell whose centre is at x or beyond.
  int first(double x) const {
    return static_cast<int>(std::clamp(std::ceil(x - 0.5), 0.0, static_cast<double>(size_)));
  }

  /// Computed from the lower end, whatever the orientation, so that both neighbours get the same number.
  static std::optional<double> crossing(Vec2 a, Vec2 b, double y) {
    if ((a[1] > y) == (b[1] > y)) return {};
    if (b[1] < a[1]) std::swap(a, b);
    return a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
  }

  int size_;
  std::vector<int> counts_;
};

}  // namespace

OverlapFacts measureOverlap(const UvMap& map, int size) {
  const Square box = boundsOf(map);
  const double side = std::max(box.high[0] - box.low[0], box.high[1] - box.low[1]);
  if (!(side > 0.0) || !std::isfinite(side)) return {};
  Grid grid(size);
  for (const auto& corners : map.cornerUv) {
    auto t = triangleOf(map, corners);
    if (!t) continue;
    for (Vec2& p : *t) {
      for (std::size_t axis = 0; axis < 2; ++axis)
        p[axis] = (p[axis] - box.low[axis]) / side * size;
    }
    grid.add(*t);
  }
  return grid.facts();
}

}  // namespace hgp
