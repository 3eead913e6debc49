// Aligns one connected surface to grids of several densities.  Role: measures the cost of alignment in distortion
// and time, and how much of it a descent with the integers held recovers.
#pragma once

#include <string>
#include <vector>

#include "distortion_run.h"

namespace hgp::bench {

/// A requested grid: "tile 25" has 25 cells per cone of the map without a grid.
struct AskedGrid {
  const char* name;
  double perCone;
  bool isQuad;
};
inline constexpr AskedGrid kAskedGrids[] = {
    {"tile 25", 25.0, false}, {"tile 100", 100.0, false}, {"quad 25", 25.0, true}};

/// The requested improvements, the first of which is none.
inline constexpr const char* kGridKinds[] = {kPlain, kIsometric, kConformal};

/// Names of the maps of an aligned run. kAligned: before the descent, or the final map without an improvement.
std::string alignedName(const char* kind, const AskedGrid& grid);
std::string descendedName(const char* kind, const AskedGrid& grid);

/// The maps without a grid, named by kind, then those for every grid and kind. Of maps that could not be aligned, only
/// the name and a note are given.
SurfaceRow compareGrids(const std::string& name, const TriMesh& mesh, int q);

/// How many maps are aligned and, for those, compared with the run without a grid: increase of mean μ, ratio of the
/// excess and additional time, as medians and worst cases in Markdown.
std::string gridSummary(const std::vector<SurfaceRow>& rows);

}  // namespace hgp::bench
