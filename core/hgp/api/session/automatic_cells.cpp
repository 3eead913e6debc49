#include "hgp/api/session/automatic_cells.h"

#include <algorithm>
#include <cmath>

#include "hgp/api/session/session_state.h"
#include "hgp/grid/grid_measures.h"
#include "hgp/mesh/box.h"
#include "hgp/mesh/finite.h"

namespace hgp::api {
namespace {

constexpr double kCellsAcross = 14.0;
constexpr double kFewest = 800.0;
constexpr double kPerCone = 40.0;
constexpr double kMost = 1e6;

}  // namespace

double automaticCells(const Model& model, const Request& request) {
  double area = 0.0;
  std::size_t cones = 0;
  for (const ModelComponent& component : model.components) area += surfaceArea(component.mesh);
  for (const ComponentRequest& component : request.components) cones += component.spec.cones.size();
  const double across = kCellsAcross / diagonal(finiteBoxOf(model.mesh.positions));
  const double cells =
      std::max({area * across * across, kFewest, kPerCone * static_cast<double>(cones)});
  return std::round(std::min(cells, kMost));
}

SolveOptions Session::State::withCells(const Request& request, SolveOptions options) const {
  if (options.choosesCells && !options.grid.isAsked())
    options.grid.cells = automaticCells(*model, request);
  return options;
}

}  // namespace hgp::api
