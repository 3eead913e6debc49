#include "hgp/io/placements.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/portable_math.h"
#include "hgp/mesh/vectors.h"

namespace hgp::io {

double scaleOf(const Placements& placements) {
  double largest = 0.0;
  for (const std::array<double, 16>& m : placements.matrices) {
    const Vec3 x{m[0], m[1], m[2]}, y{m[4], m[5], m[6]}, z{m[8], m[9], m[10]};
    largest = std::max(largest, std::fabs(dot(x, cross(y, z))));
  }
  if (!(largest > 0.0) || !std::isfinite(largest)) return 1.0;
  return portable::exp(portable::log(largest) / 3.0);
}

}  // namespace hgp::io
