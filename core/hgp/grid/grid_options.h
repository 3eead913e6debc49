// What a caller may ask of a grid, and what came of it.  Role: the words of align.h that options and
// reports are made of.
#pragma once

#include <string>
#include <vector>

#include "hgp/base/ids.h"

namespace hgp {

enum class GridMode {
  kTile,  ///< translations are Gaussian integers; cones may lie between grid points
  kQuad,  ///< cones lie on grid points as well, so that the grid is a quad mesh
};

/// Nothing is asked while both sizes are 0. Only for q = 2 and 4.
struct GridOptions {
  double cells = 0.0;    ///< grid cells in all, about
  double spacing = 0.0;  ///< or: edge of a cell in units of the surface
  GridMode mode = GridMode::kTile;
  bool isAsked() const { return cells > 0.0 || spacing > 0.0; }
};

/// One choice of integers.
struct GridAttempt {
  std::string method;   ///< "linear step", "patches of 6 rings", …
  double factor = 1.0;  ///< by which the asked density was multiplied
  int turned = 0;       ///< triangles that are not positive
};

/// Two cones that are neighbours in the map as solved.
struct ConeDistance {
  VertexId a, b;
  double cells = 0.0;  ///< along the way between them, at the density asked
};

struct GridReport {
  bool isAligned = false;
  double cells = 0.0;         ///< reached: area of the map in cells
  double spacing = 0.0;       ///< reached, in units of the surface
  double cellsPerCone = 0.0;  ///< of what was reached or, without a map, asked
  int integers = 0;           ///< free Gaussian integers
  std::vector<GridAttempt> attempts;
  std::string reason;  ///< why there is none
  std::vector<ConeDistance>
      closest;  ///< then: the cones that are in each other's way, closest first
  double workingCells =
      0.0;  ///< without a map: a density at which there is one, 0 if none was found
};

}  // namespace hgp
