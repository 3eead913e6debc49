// Lengths near 1.  Role: products of several lengths stay in range on surfaces that are very small or very large.
#pragma once

#include <algorithm>
#include <cmath>

namespace hgp {

/// The power of two that brings `length` to [1, 2): scaling by it is exact.
inline double unitScale(double length) {
  return std::scalbn(1.0, -std::ilogb(std::clamp(length, 1e-300, 1e300)));
}

}  // namespace hgp
