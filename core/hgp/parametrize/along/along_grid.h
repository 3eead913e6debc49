// Maps along features on a grid.  Role: lines, translations and, for quads, cones go to integers, and the same program is
// solved with these given.
#pragma once

#include "hgp/grid/grid_options.h"
#include "hgp/parametrize/along/straight_run.h"

namespace hgp {

struct StraightGrid {
  std::optional<StraightAttempt>
      attempt;               ///< in cells, snapped; nothing if no integers led to a map
  std::vector<char> isHeld;  ///< by real unknown: 1 where its value is given
  GridReport report;
  bool isCancelled = false;
};

/// Every feature edge, rims included, lies on a line of integers; so do the ends of features and cones, on both, in
/// GridMode::kQuad. Integers are chosen near the map as solved, in the metric of the program's objective, so that lines
/// that face each other, ends of one line and cones stay apart (grid/line_gaps.h); then the program is solved for the
/// rest. A few densities are tried, the one asked for first.
/// @param z  per copy, of a certified map along features, as solved
StraightGrid alignAlong(const TriMesh& mesh, const StraightSetup& setup,
                        const std::vector<Complex>& z, const Eigen::VectorXd& x,
                        const ParametrizeOptions& options);

}  // namespace hgp
