#include "hgp/io/polygon/polygon_mesh.h"

#include "hgp/io/polygon/ear_clipping.h"
#include "hgp/io/polygon/separate_diagonals.h"
#include "hgp/mesh/finite.h"

namespace hgp::io {
namespace {

Failure tooManyCorners() {
  return {ErrorCode::kLimit,
          "read",
          "the polygons of this file have too many corners to be triangulated here; "
          "triangulate them first",
          {}};
}

}  // namespace

Result<TriangleCorners> triangulate(const PolygonMesh& polygons) {
  TriangleCorners corners;
  if (polygons.isTriangles()) return corners;
  corners.reserve(static_cast<std::size_t>(polygons.triangleCount()));
  std::int64_t tests = 0;
  std::vector<Vec3> points;
  const Vec3 centre = centreOf(finiteBoxOf(polygons.positions));
  for (std::size_t p = 0; p + 1 < polygons.start.size(); ++p) {
    const int first = static_cast<int>(polygons.start[p]);
    const int last = static_cast<int>(polygons.start[p + 1]);
    if (last - first == 3) {
      corners.push_back({first, first + 1, first + 2});
      continue;
    }
    points.clear();
    for (int c = first; c < last; ++c) {
      const int v = polygons.cornerVertex[static_cast<std::size_t>(c)];
      points.push_back(polygons.positions[static_cast<std::size_t>(v)]);
    }
    for (const auto& t : clipEars(points, centre, tests)) {
      corners.push_back({first + t[0], first + t[1], first + t[2]});
    }
    if (tests > kMaxEarTests) return tooManyCorners();
  }
  separateDiagonals(polygons, corners, tests);
  if (tests > kMaxEarTests) return tooManyCorners();
  return corners;
}

MeshData triangleMesh(const PolygonMesh& polygons, const TriangleCorners& corners) {
  MeshData mesh;
  mesh.positions = polygons.positions;
  const std::size_t count = static_cast<std::size_t>(polygons.triangleCount());
  mesh.triangles.resize(count);
  for (std::size_t t = 0; t < count; ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t c = corners.empty() ? 3 * t + k : static_cast<std::size_t>(corners[t][k]);
      mesh.triangles[t][k] = polygons.cornerVertex[c];
    }
  }
  return mesh;
}

}  // namespace hgp::io
