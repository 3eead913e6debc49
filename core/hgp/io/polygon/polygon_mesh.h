// Polygons of a file, their triangulation, and uv per polygon corner.
// Role: polygons are solved on a triangulation, and the uv are transferred back to polygon corners.
#pragma once

#include <vector>

#include "hgp/base/result.h"
#include "hgp/io/polygons.h"

namespace hgp::io {

/// Maximum number of corners of a polygon: ear clipping takes quadratic time, and files may be hostile.
inline constexpr int kMaxPolygonCorners = 10'000;

/// Ear clipping in the plane of the polygon's Newell normal; the ear with the largest smallest angle is cut
/// first. Concave planar polygons are triangulated correctly, and every polygon of n corners gives n − 2
/// triangles. No diagonal repeats a side or a diagonal of another polygon where that can be avoided
/// (separate_diagonals.h). Depends on positions and polygons alone, so that a written file is triangulated in the
/// same way when read. Fails with kLimit beyond 4 · 10⁸ point-in-triangle tests.
Result<TriangleCorners> triangulate(const PolygonMesh& polygons);

/// The mesh of these triangles.
MeshData triangleMesh(const PolygonMesh& polygons, const TriangleCorners& corners);

/// One uv index per polygon corner, and the same map on triangles. Where a seam runs along an
/// inner diagonal of a polygon, the triangles across it are moved by the seam's rigid
/// motion, so that the seam runs along the polygon's sides instead. Triangles whose part is −1 follow the others of
/// their polygon. Unused uv are dropped.
struct PolygonUv {
  UvMap map;
  std::vector<int> cornerUv;  ///< |corners|, index into map.uv
  int carriedPolygons = 0;
};
PolygonUv keepPolygonsWhole(const PolygonMesh& polygons, const TriangleCorners& corners,
                            const UvMap& map, const std::vector<int>& partOf = {});

}  // namespace hgp::io
