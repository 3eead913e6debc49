#include "hgp/grid/grid_measures.h"

#include <algorithm>
#include <cmath>

#include "hgp/mesh/map_area.h"
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

void describeGrid(const TriMesh& mesh, const UvMap& map, std::size_t coneCount,
                  GridReport& report) {
  report.cells = mapArea(map);
  report.spacing = std::sqrt(surfaceArea(mesh) / report.cells);
  report.cellsPerCone = report.cells / std::max<double>(1.0, static_cast<double>(coneCount));
}

}  // namespace hgp
