#include "hgp/grid/grid_measures.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/check.h"
#include "hgp/mesh/vectors.h"

namespace hgp {

double surfaceArea(const TriMesh& mesh) {
  double area = 0.0;
  for (FaceId f : mesh.faces()) {
    const auto [i, j, k] = mesh.corners(f);
    area += triangleArea(mesh.position(i), mesh.position(j), mesh.position(k));
  }
  return area;
}

double mapArea(const UvMap& map) {
  double area = 0.0;
  for (const auto& t : map.cornerUv) {
    const Vec2 &a = map.uv[at(t[0])], &b = map.uv[at(t[1])], &c = map.uv[at(t[2])];
    area += 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
  }
  return area;
}

void describeGrid(const TriMesh& mesh, const UvMap& map, std::size_t coneCount,
                  GridReport& report) {
  report.cells = mapArea(map);
  report.spacing = std::sqrt(surfaceArea(mesh) / report.cells);
  report.cellsPerCone = report.cells / std::max<double>(1.0, static_cast<double>(coneCount));
}

}  // namespace hgp
