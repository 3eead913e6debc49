// Options and report of an alignment to a grid.  Role: the types of align.h that other options and reports contain.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hgp/base/ids.h"
#include "hgp/base/note.h"

namespace hgp {

enum class GridMode {
  kTile,  ///< translations are Gaussian integers; cones may lie between grid points
  kQuad,  ///< cones lie on grid points as well, so that the grid is a quad mesh
};

/// No grid while both sizes are 0. Only for q = 2 and 4.
struct GridOptions {
  double cells = 0.0;    ///< approximate number of cells of the whole map
  double spacing = 0.0;  ///< or: edge length of a cell in units of the surface
  GridMode mode = GridMode::kTile;
  bool isAsked() const { return cells > 0.0 || spacing > 0.0; }
};

/// One choice of integers.
struct GridAttempt {
  std::string method;   ///< "linear step", "patches of 6 rings", …
  double factor = 1.0;  ///< ratio to the requested density
  int turned = 0;       ///< triangles that are not positive
};

/// Two cones that are neighbours in the map as solved.
struct ConeDistance {
  VertexId a, b;
  double cells = 0.0;  ///< length of the path between them in cells, at the requested density
};

struct GridReport {
  bool isAligned = false;
  double cells = 0.0;         ///< area of the aligned map in cells
  double spacing = 0.0;       ///< edge length of its cells, in units of the surface
  double cellsPerCone = 0.0;  ///< of the aligned map or, if there is none, as requested
  double added = 0.0;         ///< quads that its quad mesh has beyond that: see quads/cut_strips.h
  int integers = 0;           ///< free Gaussian integers
  std::vector<GridAttempt> attempts;
  std::optional<Note> reason;  ///< why there is no aligned map
  std::vector<ConeDistance>
      closest;                ///< if there is none: the cones that are too close, closest first
  double workingCells = 0.0;  ///< if there is none: a number of cells that works, 0 if unknown
  bool needsTheseCones =
      false;  ///< that number was tried with the cones of this run only, which were automatic
};

}  // namespace hgp
