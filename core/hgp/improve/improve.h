// Lowers the distortion of a map without flips.  Role: the descent between solving and storing. The map stays
// seamless by construction, and locally injective by the line search.
#pragma once

#include <vector>

#include "hgp/base/progress.h"
#include "hgp/improve/face_terms.h"
#include "hgp/improve/improve_options.h"
#include "hgp/linalg/ordering/ordering.h"

namespace hgp {

struct Improvement {
  Eigen::VectorXcd x;  ///< the improved unknowns; as given when nothing was gained
  double excessBefore = 0.0, excessAfter = 0.0;  ///< mean ψ − 1, as in ImproveStep
  std::vector<ImproveStep> steps;
  DescentOutcome outcome = DescentOutcome::kNothingToGain;
  double multiplyAdds = 0.0;  ///< spent
};

/// Projected Newton on the mean Σ A_f ψ_f / Σ A_f over the unknowns, from a map without flips: A_f is
/// surface area, ψ is measured at the best global scale. No triangle degenerates anywhere between
/// the given map and the returned one, so that angle sums and turning numbers, which are integers in these units,
/// do not change; orientation is checked exactly after every step. The energy never increases.
/// @param tree  dissection of the mesh's vertices along its edges (vertexTree)
/// @param x       by column of map.unknowns.copies
/// @param isHeld  the same: 1 where x must not change (the integers of a grid, or everything outside a patch);
///                empty: none
/// @param progress  stage "improve", the excess as `residual`; return false to cancel
Improvement improve(const ReducedMap& map, const linalg::SeparatorTree& tree,
                    const Eigen::VectorXcd& x, const ImproveOptions& options,
                    const std::vector<char>& isHeld = {}, const Progress& progress = {});

}  // namespace hgp
