// Other automatic cones for a grid that the first ones leave no room.  Role: the last resort before a map is
// reported as not aligned, and the advice in that report.
#pragma once

#include <functional>

#include "hgp/api/options.h"
#include "hgp/parametrize/parametrization.h"

namespace hgp::api {

/// Chooses cones as options say, with the spacing for their grid, and solves with them for the grid given apart.
using SolveAutomatic =
    std::function<Result<Parametrization>(const SolveOptions& cones, const GridOptions& grid)>;

/// If `run` is certified but not aligned, or only with a number of cells far from that asked for: the cones of coarser grids, which are farther apart, and then few cones.
/// Replaces `run` by the first result that is aligned, with a note. If none is, the number of cells that the
/// report advises is tried as a run would try it; without success there is no such number. On larger surfaces that is
/// not tried, and the report says that the number belongs to its cones. Fails with kCancelled only.
/// @param grid  by spacing
Status withOtherCones(int triangles, const SolveOptions& options, const GridOptions& grid,
                      const SolveAutomatic& solve, Result<Parametrization>& run, Notes& notes);

/// The cells of an aligned map, in quad mode with the quads added beyond them, relative to those asked for.
double cellsToAsked(const GridReport& report, const GridOptions& grid);
/// A number of cells within this fraction of the one asked for is near it.
inline constexpr double kNearCells = 0.1;

/// The grid of a component among others: cells of the shared size or, where that leaves fewer than kMinCells, of a half,
/// a quarter, … of their length, so that textures that fit the others' cells fit these.
/// @param grid  by spacing; @param finer  halvings in addition
GridOptions wholeFraction(const GridOptions& grid, double area, int finer, int& halvings);
inline constexpr double kMinCells = 8.0;
/// Components of fewer cells than this that are not aligned are tried with cells of half the length, and of a quarter.
inline constexpr double kFewCells = 100.0;
inline constexpr int kMaxFiner = 2;

}  // namespace hgp::api
