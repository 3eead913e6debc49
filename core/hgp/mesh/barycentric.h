// Barycentric coordinates of a point near a triangle.  Role: the weights with which attributes are interpolated.
#pragma once

#include <algorithm>
#include <array>

#include "hgp/mesh/unit_scale.h"
#include "hgp/mesh/vectors.h"

namespace hgp {

/// Those of the point of the triangle's plane nearest to p, cut off at 0 and scaled to the sum 1; of a triangle without area,
/// those of the corner nearest to p.
inline std::array<double, 3> weightsIn(const std::array<Vec3, 3>& triangle, const Vec3& p) {
  const double unit =
      unitScale(std::max({distance(triangle[1], triangle[0]), distance(triangle[2], triangle[0]),
                          distance(p, triangle[0])}));
  const auto to = [&](std::size_t c, const Vec3& from) {
    return scaled(subtract(triangle[c % 3], from), unit);
  };
  const Vec3 normal = cross(to(1, triangle[0]), to(2, triangle[0]));
  std::array<double, 3> weight{};
  double sum = 0.0;
  for (std::size_t c = 0; c < 3; ++c) {
    weight[c] = std::max(dot(cross(to(c + 1, p), to(c + 2, p)), normal), 0.0);
    sum += weight[c];
  }
  if (!(sum > 0.0)) {
    const auto nearest = std::min_element(
        triangle.begin(), triangle.end(),
        [&](const Vec3& a, const Vec3& b) { return distance(a, p) < distance(b, p); });
    weight[static_cast<std::size_t>(nearest - triangle.begin())] = 1.0;
    return weight;
  }
  for (double& w : weight) w /= sum;
  return weight;
}

}  // namespace hgp
