// The area of a map.  Role: the cells of an aligned one.
#pragma once

#include "hgp/mesh/mesh_data.h"

namespace hgp {

/// Of the triangles in the plane, signed.
inline double mapArea(const UvMap& map) {
  double area = 0.0;
  for (const auto& t : map.cornerUv) {
    const auto corner = [&](std::size_t k) { return map.uv[static_cast<std::size_t>(t[k])]; };
    const Vec2 a = corner(0), b = corner(1), c = corner(2);
    area += 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
  }
  return area;
}

}  // namespace hgp
