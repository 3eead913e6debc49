// Elimination order of real unknowns.  Role: one dissection serves every program of a map along features.
#pragma once

#include <optional>
#include <vector>

#include "hgp/features/real_unknowns.h"
#include "hgp/linalg/ordering/ordering.h"
#include "hgp/system/seamless_system.h"

namespace hgp {

/// The separators of a quadratic form of harmonic rows and of the triangles' distortion. The two parts of a vertex are dissected
/// separately, since turned seams alone couple them; unknowns of several vertices (lines of features, translations) are
/// appended. Computed when it is first needed.
class RealTree {
 public:
  /// @param system, unknowns, hasRow  as in StraightSystem; the same in every call
  /// @param number  per unknown, its name in the tree; −1 leaves it out
  linalg::SeparatorTree get(const SeamlessSystem& system, const RealUnknowns& unknowns,
                            const PerVertex<char>& hasRow, const std::vector<int>& number);

 private:
  std::optional<linalg::SeparatorTree> tree_;  ///< of all unknowns
};

}  // namespace hgp
