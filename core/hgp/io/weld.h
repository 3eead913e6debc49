// Joins vertices at equal positions.  Role: STL and glTF store one vertex several times.
#pragma once

#include <vector>

#include "hgp/mesh/mesh_data.h"

namespace hgp::io {

struct Weld {
  std::vector<Vec3> positions;   ///< one per welded vertex, in order of first occurrence
  std::vector<int> welded;       ///< stored vertex → welded vertex
  std::vector<int> firstStored;  ///< welded vertex → first stored vertex
};

/// Joins vertices whose three coordinates are equal (0 and −0 are). O(n) expected.
Weld weldExact(const std::vector<Vec3>& positions);

/// Joins every vertex to the first vertex closer than `tolerance`, found by a grid with cells of that size.
Weld weldNear(const std::vector<Vec3>& positions, double tolerance);

/// Joins copies of one vertex that have the same uv: formats split vertices for other attributes as well.
void joinEqualCopies(const MeshData& mesh, UvMap& map);

}  // namespace hgp::io
