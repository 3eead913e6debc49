// One connected surface, aligned to grids of several densities.  Role: what alignment costs in distortion
// and time, and what a descent with the integers held gains of it.
#pragma once

#include <string>
#include <vector>

#include "distortion_run.h"

namespace hgp::bench {

/// A grid that is asked for: "tile 25" is 25 cells per cone of the map without a grid.
struct AskedGrid {
  const char* name;
  double perCone;
  bool isQuad;
};
inline constexpr AskedGrid kAskedGrids[] = {
    {"tile 25", 25.0, false}, {"tile 100", 100.0, false}, {"quad 25", 25.0, true}};

/// What is asked of the map: nothing, or an improvement.
inline constexpr const char* kGridKinds[] = {kPlain, kIsometric, kConformal};

/// Names of the maps of an aligned run. kAligned: before the descent; where nothing is asked the last one.
std::string alignedName(const char* kind, const AskedGrid& grid);
std::string descendedName(const char* kind, const AskedGrid& grid);

/// Without a grid, named by kind; then every grid for every kind. Maps that could not be aligned are left
/// out but for their name and note.
SurfaceRow compareGrids(const std::string& name, const TriMesh& mesh, int q);

/// How many are aligned; and of those, against the run without a grid: rise of mean μ, ratio of the excess,
/// time added, as medians and worst cases in Markdown.
std::string gridSummary(const std::vector<SurfaceRow>& rows);

}  // namespace hgp::bench
