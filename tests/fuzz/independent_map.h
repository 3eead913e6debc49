// A map verified from its numbers alone, by nothing of the library.  Role: what fuzz_solve holds every
// certificate against.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "hgp/mesh/vectors.h"

namespace hgp::fuzz {

/// Flat arrays as the session gives them.
struct FlatMap {
  const std::vector<std::uint32_t>& triangles;   ///< × 3
  const std::vector<std::uint32_t>& cornerToUv;  ///< × 3
  const std::vector<double>& uv;                 ///< × 2
  int q = 4;
  std::map<int, int> cones;  ///< vertex → k; every other inner vertex has k = q
  double tolerance = 2e-6;   ///< of a seam edge's length, and radians
};

using Wide = __float128;

/// Whether a triangle's area is not positive beyond what 113 bits may err.
inline bool isTurned(const FlatMap& map, std::size_t f) {
  Wide p[3][2];
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 2; ++i) p[k][i] = map.uv[2 * map.cornerToUv[3 * f + k] + i];
  const Wide left = (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]);
  const Wide right = (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]);
  const auto size = [](Wide x) { return x < 0 ? -x : x; };
  const Wide error = (size(left) + size(right)) * static_cast<Wide>(1e-32);
  return left - right < -error || (left == right && left == 0);
}

inline std::array<double, 2> edgeOf(const FlatMap& map, std::size_t corner) {
  const std::size_t next = corner % 3 == 2 ? corner - 2 : corner + 1;
  const std::size_t a = map.cornerToUv[corner], b = map.cornerToUv[next];
  return {map.uv[2 * b] - map.uv[2 * a], map.uv[2 * b + 1] - map.uv[2 * a + 1]};
}

/// The first law that is broken, or nullptr. @pre the triangles are an oriented manifold
inline const char* brokenLaw(const FlatMap& map) {
  constexpr double kTurn = 6.283185307179586;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> halfedges;
  std::map<std::uint32_t, double> angles;
  std::map<std::uint32_t, int> balance;  ///< edges out minus edges in that have no twin: 0 inside
  for (std::size_t i = 0; i < map.cornerToUv.size(); ++i) {
    if (2 * std::size_t{map.cornerToUv[i]} + 1 >= map.uv.size())
      return "a corner names uv that are not there";
    if (!std::isfinite(map.uv[2 * map.cornerToUv[i]]) ||
        !std::isfinite(map.uv[2 * map.cornerToUv[i] + 1]))
      return "uv are finite";
    const std::size_t next = i % 3 == 2 ? i - 2 : i + 1, before = i % 3 == 0 ? i + 2 : i - 1;
    halfedges[{map.triangles[i], map.triangles[next]}] = i;
    const auto out = edgeOf(map, i), in = edgeOf(map, before);
    angles[map.triangles[i]] +=
        std::atan2(out[1] * in[0] - out[0] * in[1], -out[0] * in[0] - out[1] * in[1]);
  }
  for (std::size_t f = 0; 3 * f < map.cornerToUv.size(); ++f)
    if (isTurned(map, f)) return "every triangle is positive";
  for (const auto& [ends, i] : halfedges) {
    const auto twin = halfedges.find({ends.second, ends.first});
    if (twin == halfedges.end()) {
      balance[ends.first] += 1;
      balance[ends.second] += 1;
      continue;
    }
    const auto d = edgeOf(map, i), e = edgeOf(map, twin->second);
    const double length = std::hypot(d[0], d[1]);
    double best = 1e300;
    for (int r = 0; r < map.q; ++r) {
      const double c = std::cos(kTurn * r / map.q), s = std::sin(kTurn * r / map.q);
      best = std::min(best, std::hypot(-e[0] - c * d[0] + s * d[1], -e[1] - s * d[0] - c * d[1]));
    }
    if (best > map.tolerance * length) return "the two sides of an edge differ by a rotation";
  }
  for (const auto& [vertex, sum] : angles) {
    if (balance.count(vertex) > 0) continue;
    const auto cone = map.cones.find(static_cast<int>(vertex));
    const int k = cone == map.cones.end() ? map.q : cone->second;
    if (std::fabs(sum - kTurn * k / map.q) > map.tolerance) return "every angle sum is as asked";
  }
  return nullptr;
}

}  // namespace hgp::fuzz
