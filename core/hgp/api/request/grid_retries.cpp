#include "hgp/api/request/grid_retries.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/check.h"

namespace hgp::api {
namespace {

/// Up to this many triangles, few cones and the advised number of cells are tried: about a second each.
constexpr int kChosenTwice = 10'000;
/// Cones are chosen for cells that are larger by these factors. On larger surfaces only the first are tried.
constexpr double kCoarser[] = {1.5, 2.0, 3.0, 4.0, 8.0};
constexpr std::size_t kCoarserOnLarge = 2;
constexpr int kLarge = 100'000;
/// Advised numbers of cells, each twice the one before, that are tried.
constexpr int kAdvised = 3;

bool isAligned(const Result<Parametrization>& run) {
  return run && run->isCertified && run->grid && run->grid->isAligned;
}
/// Whether it also has about as many cells as asked for: alignment takes what it can get from densities farther off.
bool isNear(const Result<Parametrization>& run, const GridOptions& grid) {
  return isAligned(run) && std::fabs(cellsToAsked(*run->grid, grid) - 1.0) <= kNearCells;
}
bool isCancelled(const Result<Parametrization>& run) {
  return !run && run.error().code == ErrorCode::kCancelled;
}

class Retries {
 public:
  Retries(int triangles, const SolveOptions& options, const SolveAutomatic& solve)
      : triangles_(triangles), options_(options), solve_(solve) {}

  /// An aligned result with cones for a coarser grid, if there is one: the first that is near or, unless it must be, the
  /// nearest; or a cancelled one.
  std::optional<Result<Parametrization>> coarser(const GridOptions& grid, bool mustBeNear,
                                                 double& factor) {
    const std::size_t count = triangles_ > kLarge ? kCoarserOnLarge : std::size(kCoarser);
    std::optional<Result<Parametrization>> far;
    for (std::size_t n = 0; n < count; ++n) {
      SolveOptions choice = options_;
      choice.grid = {0.0, kCoarser[n] * grid.spacing, grid.mode};
      Result<Parametrization> run = solve_(choice, grid);
      if (isCancelled(run) || isNear(run, grid)) {
        factor = kCoarser[n];
        return run;
      }
      if (mustBeNear || !isAligned(run)) continue;
      if (far && offBy(*far, grid) <= offBy(run, grid)) continue;
      factor = kCoarser[n];
      far = std::move(run);
    }
    return far;
  }
  std::optional<Result<Parametrization>> few(const GridOptions& grid) {
    SolveOptions choice = options_;
    choice.conesFor = ConesFor::kFew;
    choice.grid = grid;
    Result<Parametrization> run = solve_(choice, grid);
    if (isCancelled(run) || isAligned(run)) return run;
    return {};
  }
  /// What a new run would do.
  std::optional<Result<Parametrization>> all(const GridOptions& grid) {
    SolveOptions choice = options_;
    choice.grid = grid;
    Result<Parametrization> run = solve_(choice, grid);
    if (isCancelled(run) || isAligned(run)) return run;
    double factor = 1.0;
    return coarser(grid, false, factor);
  }

 private:
  static double offBy(const Result<Parametrization>& run, const GridOptions& grid) {
    const double ratio = cellsToAsked(*run->grid, grid);
    return std::max(ratio, 1.0 / ratio);
  }

  int triangles_;
  const SolveOptions& options_;
  const SolveAutomatic& solve_;
};

/// The advised number of cells, or twice or four times as many, if a run with it is aligned; else none.
Status testAdvice(Retries& retries, const GridOptions& grid, GridReport& report) {
  double cells = report.workingCells;
  report.workingCells = 0.0;
  for (int n = 0; n < kAdvised && cells > 0.0; ++n, cells *= 2.0) {
    const double spacing = grid.spacing * std::sqrt(report.cells / cells);
    const auto run = retries.all({0.0, spacing, grid.mode});
    if (run && isCancelled(*run)) return run->error();
    if (!run) continue;
    report.workingCells = cells;
    break;
  }
  return Done{};
}

}  // namespace

Status withOtherCones(int triangles, const SolveOptions& options, const GridOptions& grid,
                      const SolveAutomatic& solve, Result<Parametrization>& run, Notes& notes) {
  if (!grid.isAsked() || !run || !run->isCertified || isNear(run, grid)) return Done{};
  Retries retries(triangles, options, solve);
  Notes before = notes;
  double factor = 1.0;
  std::optional<Result<Parametrization>> other = retries.coarser(grid, isAligned(run), factor);
  if (other && isCancelled(*other)) return other->error();
  if (other) {
    notes.push_back(Note("grid-other-cones", {{"factor", factor}}));
    run = std::move(*other);
    return Done{};
  }
  notes = before;
  const bool isFar = isAligned(run);
  const bool mayBeFew = options.coneCount == 0 && !options.alignToCurvature &&
                        options.conesFor == ConesFor::kBalanced;
  if (isFar && (!mayBeFew || triangles > kChosenTwice)) return Done{};
  if (triangles > kChosenTwice) {
    if (mayBeFew) notes.emplace_back("grid-few-advised");
    run->grid->needsTheseCones = true;
    return Done{};
  }
  if (mayBeFew) {
    other = retries.few(grid);
    if (other && isCancelled(*other)) return other->error();
    if (other && (!isFar || isNear(*other, grid))) {
      notes.emplace_back("grid-few-used");
      run = std::move(*other);
      return Done{};
    }
  }
  if (isFar) {
    notes = std::move(before);
    return Done{};
  }
  const Status done = testAdvice(retries, grid, *run->grid);
  notes = std::move(before);
  return done;
}

double cellsToAsked(const GridReport& report, const GridOptions& grid) {
  const double ratio =
      grid.spacing > 0.0 ? grid.spacing / report.spacing : std::sqrt(report.cells / grid.cells);
  return ratio * ratio * (1.0 + report.added / report.cells);
}

GridOptions wholeFraction(const GridOptions& grid, double area, int finer, int& halvings) {
  GridOptions out = grid;
  halvings = finer;
  if (!(area > 0.0) || !(grid.spacing > 0.0)) return out;
  // Neither the square of a spacing nor that of a side need be a number of this range.
  for (double side = std::sqrt(area) / grid.spacing; side > 0.0 && side * side < kMinCells;) {
    side *= 2.0;
    ++halvings;
  }
  out.spacing = std::ldexp(grid.spacing, -halvings);
  return out;
}

}  // namespace hgp::api
