// Seams that hold exactly in the stored numbers.  Role: (12) of [BCW17] without any tolerance:
// z' = e^{i2πr/q} z + t on both ends of an edge, with the same t.
#pragma once

#include <vector>

#include "hgp/verify/seams.h"

namespace hgp {

struct ExactSeamFacts {
  bool isApplicable = false;  ///< q is 1, 2, 3, 4 or 6: other rotations keep no lattice
  bool isTriangular =
      false;      ///< q is 3 or 6: what holds does so between the points that the numbers stand for
  int exact = 0;  ///< seam edges of SeamFacts::seams that hold exactly
  int integer = 0;  ///< of those, with t ∈ Z[i] or Z[ω]: a unit grid continues across them
  std::vector<EdgeId> inexact;  ///< the others, ascending
};

/// For q = 1, 2, 4 sums of two stored numbers are compared as real numbers, without rounding. For q = 3, 6 the numbers
/// are read as points of a triangular lattice (lattice_points.h) and compared as integers; no seam is exact where they
/// are no such points.
/// @param uv     as stored, unscaled
/// @param seams  from measureSeams, whose rotations are used
ExactSeamFacts measureExactSeams(const TriMesh& mesh, int q, const CornerUv& uv,
                                 const SeamFacts& seams);

}  // namespace hgp
