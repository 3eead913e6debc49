// Finite positions.  Role: readers and repairs use the same definition.
#pragma once

#include <cmath>
#include <vector>

#include "hgp/mesh/box.h"
#include "hgp/mesh/mesh_data.h"

namespace hgp {

inline bool isFinite(const Vec3& p) {
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

/// The bounding box of the points that are finite.
inline Box<3> finiteBoxOf(const std::vector<Vec3>& points) {
  Box<3> box;
  for (const Vec3& p : points)
    if (isFinite(p)) box.add(p);
  return box;
}

/// Vertices without faces whose position is not finite, ascending. This is not a defect: they are kept as they are.
std::vector<int> unusedNotFinite(const MeshData& data);

}  // namespace hgp
