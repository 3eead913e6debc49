// Polygons of a file, their triangulation, and uv per polygon corner.
// Role: polygons are solved on a triangulation, and the uv are transferred back to polygon corners.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "hgp/base/result.h"
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

/// Maximum number of corners of a polygon: ear clipping takes quadratic time, and files may be hostile.
inline constexpr int kMaxPolygonCorners = 10'000;

/// The three corners of every triangle. Empty when every polygon is a triangle (corner 3t + k).
using TriangleCorners = std::vector<std::array<int, 3>>;

/// Ear clipping in the plane of the polygon's Newell normal; the ear with the largest smallest angle is cut
/// first. Concave planar polygons are triangulated correctly, and every polygon of n corners gives n − 2
/// triangles. Depends on positions alone, so that a written file is triangulated in the same way when read.
/// Fails with kLimit beyond 4 · 10⁸ point-in-triangle tests.
Result<TriangleCorners> triangulate(const PolygonMesh& polygons);

/// The mesh of these triangles.
MeshData triangleMesh(const PolygonMesh& polygons, const TriangleCorners& corners);

/// One uv index per polygon corner, and the same map on triangles. Where a seam runs along an
/// inner diagonal of a polygon, the triangles across it are moved by the seam's rigid
/// motion, so that the seam runs along the polygon's sides instead. Unused uv are dropped.
struct PolygonUv {
  UvMap map;
  std::vector<int> cornerUv;  ///< |corners|, index into map.uv
  int carriedPolygons = 0;
};
PolygonUv keepPolygonsWhole(const PolygonMesh& polygons, const TriangleCorners& corners,
                            const UvMap& map);

}  // namespace hgp::io
