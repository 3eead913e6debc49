#include "hgp/api/model/cell_lengths.h"

#include <algorithm>
#include <cmath>

#include "hgp/mesh/finite.h"
#include "hgp/mesh/vectors.h"

namespace hgp::api {
namespace {

double areaOf(const MeshData& mesh) {
  double area = 0.0;
  const auto count = static_cast<int>(mesh.positions.size());
  for (const auto& t : mesh.triangles) {
    // Defects are looked for later.
    if (std::any_of(t.begin(), t.end(), [&](int v) { return v < 0 || v >= count; })) continue;
    const double of =
        triangleArea(mesh.positions[at(t[0])], mesh.positions[at(t[1])], mesh.positions[at(t[2])]);
    if (std::isfinite(of)) area += of;
  }
  return area;
}

}  // namespace

std::vector<double> cellLengths(const io::Document& document) {
  const std::vector<io::Surface>& surfaces = document.surfaces();
  if (surfaces.size() < 2) return {};
  const std::vector<io::Placements> placements = document.placements();
  std::vector<double> scales(surfaces.size(), 1.0);
  double diagonalOfLargest = 0.0;
  std::size_t largest = 0;
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    if (s < placements.size()) scales[s] = io::scaleOf(placements[s]);
    const double shown = scales[s] * diagonal(finiteBoxOf(surfaces[s].mesh.positions));
    if (!(shown > diagonalOfLargest)) continue;
    diagonalOfLargest = shown;
    largest = s;
  }
  const double length =
      std::min(diagonalOfLargest / kCellsAcross,
               scales[largest] * std::sqrt(areaOf(surfaces[largest].mesh) / kFewestCells));
  if (!(length > 0.0) || !std::isfinite(length)) return {};
  std::vector<double> lengths;
  lengths.reserve(scales.size());
  for (const double scale : scales) lengths.push_back(length / scale);
  return lengths;
}

}  // namespace hgp::api
