// What a caller may ask of a grid.  Role: the words of align.h.
#pragma once

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

}  // namespace hgp
