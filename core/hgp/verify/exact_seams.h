// Seams that hold exactly in the stored numbers.  Role: (12) of [BCW17] without any tolerance:
// z' = i^r z + t on both ends of an edge, with the same t.
#pragma once

#include <vector>

#include "hgp/verify/seams.h"

namespace hgp {

struct ExactSeamFacts {
  bool isApplicable = false;    ///< q is 1, 2 or 4: only those rotations have exact coordinates
  int exact = 0;                ///< seam edges of SeamFacts::seams that hold exactly
  int integer = 0;              ///< of those, with t ∈ Z[i]: a unit grid continues across them
  std::vector<EdgeId> inexact;  ///< the others, ascending
};

/// Sums of two stored numbers are compared as real numbers, without rounding.
/// @param uv     as stored, unscaled
/// @param seams  from measureSeams, whose rotations are used
ExactSeamFacts measureExactSeams(const TriMesh& mesh, int q, const CornerUv& uv,
                                 const SeamFacts& seams);

}  // namespace hgp
