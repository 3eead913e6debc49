// A surface as plain arrays.  Role: what io reads and writes; nothing is checked yet.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace hgp {

using Vec3 = std::array<double, 3>;
using Vec2 = std::array<double, 2>;

/// Triangles over shared vertices, in the file's own order (n-gons already triangulated by io).
struct MeshData {
  std::vector<Vec3> positions;                ///< |V| × 3, any finite unit
  std::vector<std::array<int, 3>> triangles;  ///< |F| × 3, 0-based, counterclockwise from outside
};

/// A map into the plane as plain arrays: one uv per copy of a vertex, shared by corners.
struct UvMap {
  std::vector<Vec2> uv;                      ///< one per copy
  std::vector<std::array<int, 3>> cornerUv;  ///< |F| × 3, index into uv of each triangle corner
};

}  // namespace hgp
