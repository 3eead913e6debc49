#include "hgp/api/session/automatic_cells.h"

#include <algorithm>
#include <cmath>

#include "hgp/api/model/cell_lengths.h"
#include "hgp/api/session/session_state.h"
#include "hgp/grid/grid_measures.h"
#include "hgp/mesh/box.h"
#include "hgp/mesh/finite.h"
#include "hgp/parametrize/along/along_features.h"

namespace hgp::api {
namespace {

constexpr double kPerCone = 40.0, kPerConeAlong = 20.0;
/// On one of several meshes, whose automatic cones are not known yet: with fewer they are crowded.
constexpr double kFewestOfMany = 200.0;
constexpr double kMaxAutomatic = 1e6;
/// A second run is worth its time up to this many triangles.
constexpr std::size_t kRunTwice = 100'000;
/// How many times as many cells are better than other cones: tiles of a quarter of the length look much the same, but quads are
/// what somebody works with.
constexpr double kMoreTiles = 16.0, kMoreQuads = 4.0;

/// A number of cells with which every component is aligned; 0 if one of them knows none. All have one spacing, so that the
/// most demanding one decides.
double workingCells(const std::vector<Parametrization>& components) {
  double cells = 0.0, denser = 1.0;
  for (const Parametrization& component : components) {
    if (!component.grid) return 0.0;
    const GridReport& grid = *component.grid;
    cells += grid.cells;
    if (grid.isAligned) continue;
    if (!(grid.workingCells > 0.0)) return 0.0;
    denser = std::max(denser, grid.workingCells / grid.cells);
  }
  // The number itself, without a detour by which it is rounded.
  if (components.size() == 1 && denser > 1.0) return std::ceil(components[0].grid->workingCells);
  return std::ceil(cells * denser);
}

}  // namespace

double automaticCells(const Model& model, const Request& request, int conesAlong) {
  double area = 0.0;
  std::size_t cones = 0;
  for (const ModelComponent& component : model.components) area += surfaceArea(component.mesh);
  for (const ComponentRequest& component : request.components) cones += component.spec.cones.size();
  const double needed = std::max(kPerCone * static_cast<double>(cones), kPerConeAlong * conesAlong);
  const auto surface = static_cast<std::size_t>(model.surface);
  double cells = 0.0;
  if (surface < model.cellLengths.size()) {
    const double length = model.cellLengths[surface];
    cells = area / (length * length);
    while (cells > 0.0 && cells < std::max(needed, kFewestOfMany)) cells *= 4.0;
  } else {
    const double across = kCellsAcross / diagonal(finiteBoxOf(model.mesh.positions));
    cells = std::max({area * across * across, kFewestCells, needed});
  }
  return std::max(1.0, std::round(std::min(cells, kMaxAutomatic)));
}

bool isAnyNumberGood(const Model& model, const SolveOptions& options,
                     const Result<Parametrization>& run) {
  if (!options.choosesCells || model.components.size() > 1) return false;
  if (!run || !run->isCertified || !run->grid) return false;
  const GridReport& grid = *run->grid;
  if (grid.isAligned) return true;
  const double more = options.grid.mode == GridMode::kQuad ? kMoreQuads : kMoreTiles;
  return model.mesh.triangles.size() <= kRunTwice && grid.workingCells > 0.0 &&
         grid.workingCells <= more * grid.cells;
}

/// Those of the fields along the request's features; 0 where features have none.
int Session::State::conesAlong(const Request& request) {
  int cones = 0;
  for (std::size_t p = 0; p < request.components.size(); ++p) {
    const HolonomySpec& spec = request.components[p].spec;
    if (spec.features.empty()) continue;
    if (const Result<int> found = countConesAlong(surfaceOf(p), spec)) cones += *found;
    dropLarge(p);
  }
  return cones;
}

SolveOptions Session::State::withCells(const Request& request, SolveOptions options) {
  if (options.choosesCells && !options.grid.isAsked())
    options.grid.cells = automaticCells(*model, request, conesAlong(request));
  return options;
}

Status Session::State::solveWithWorkingCells(const SolveOptions& options, RunRecord& run) {
  if (!options.choosesCells || solved->isAligned || !solved->stored.isCertified) return Done{};
  if (model->mesh.triangles.size() > kRunTwice) return Done{};
  SolveOptions denser = options;
  denser.grid.cells = workingCells(run.components);
  if (!(denser.grid.cells > 0.0)) return Done{};
  denser.grid.spacing = 0.0;
  Request request;
  request.q = options.q;
  for (const Parametrization& component : run.components) {
    request.q = component.spec.q;
    request.components.push_back({toSpec(component.spec), false, std::nullopt, component.mirror});
  }
  RunRecord again;
  again.options = denser;
  again.isAutomatic = run.isAutomatic;
  again.notes = run.notes;
  std::shared_ptr<Solved> before = std::move(solved);
  solved.reset();
  const Status done = solveRequest(request, denser, again);
  if (done && solved->isAligned) {
    run = std::move(again);
    return Done{};
  }
  solved = std::move(before);
  // Nothing is advised that has just failed.
  for (Parametrization& component : run.components)
    if (component.grid) component.grid->workingCells = 0.0;
  return !done && done.error().code == ErrorCode::kCancelled ? done : Status(Done{});
}

}  // namespace hgp::api
