// The polygons of a file and the triangles that they are cut into.  Role: types that every module above may see.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "hgp/mesh/mesh_data.h"

namespace hgp::io {

/// Corner c of polygon p has start[p] ≤ c < start[p + 1]; every polygon has at least 3 corners.
struct PolygonMesh {
  std::vector<Vec3> positions;
  std::vector<int> cornerVertex;
  std::vector<std::uint32_t> start{0};  ///< |P| + 1

  int polygonCount() const { return static_cast<int>(start.size()) - 1; }
  int triangleCount() const { return static_cast<int>(cornerVertex.size()) - 2 * polygonCount(); }
  bool isTriangles() const {
    return cornerVertex.size() == 3 * static_cast<std::size_t>(polygonCount());
  }
  /// The triangles of polygon p are firstTriangle(p) … firstTriangle(p + 1) − 1.
  int firstTriangle(int p) const {
    return static_cast<int>(start[static_cast<std::size_t>(p)]) - 2 * p;
  }
};

/// The three corners of every triangle. Empty when every polygon is a triangle (corner 3t + k).
using TriangleCorners = std::vector<std::array<int, 3>>;

struct PolygonsView {
  const PolygonMesh* mesh = nullptr;
  const TriangleCorners* corners = nullptr;
};

}  // namespace hgp::io
