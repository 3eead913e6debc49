// Axis-aligned bounding boxes in the plane and in space.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "hgp/base/portable_math.h"

namespace hgp {

template <std::size_t N>
struct Box {
  std::array<double, N> low{}, high{};
  bool isEmpty = true;

  void add(const std::array<double, N>& p) {
    for (std::size_t k = 0; k < N; ++k) {
      low[k] = isEmpty ? p[k] : std::min(low[k], p[k]);
      high[k] = isEmpty ? p[k] : std::max(high[k], p[k]);
    }
    isEmpty = false;
  }
  double size(std::size_t k) const { return high[k] - low[k]; }
  /// The longest side.
  double extent() const {
    double most = 0.0;
    for (std::size_t k = 0; k < N; ++k) most = std::max(most, size(k));
    return most;
  }
};

template <std::size_t N>
Box<N> boxOf(const std::vector<std::array<double, N>>& points) {
  Box<N> box;
  for (const auto& p : points) box.add(p);
  return box;
}

inline double diagonal(const Box<3>& box) {
  return portable::hypot(box.size(0), box.size(1), box.size(2));
}

inline std::array<double, 3> centreOf(const Box<3>& box) {
  std::array<double, 3> centre{};
  for (std::size_t k = 0; k < 3; ++k) centre[k] = 0.5 * (box.low[k] + box.high[k]);
  return centre;
}

}  // namespace hgp
