// Joining vertices that sit at the same place.  Role: STL and glTF split vertices that are one.
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

/// Joins vertices closer than `tolerance`, first come first served, by a grid of cells of that size.
Weld weldNear(const std::vector<Vec3>& positions, double tolerance);

/// Copies of one vertex with the same uv become one: formats also split for other reasons than uv.
void joinEqualCopies(const MeshData& mesh, UvMap& map);

}  // namespace hgp::io
