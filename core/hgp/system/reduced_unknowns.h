// The free unknowns of a seamless map.  Role: (12) holds exactly because nothing else can be
// expressed; a rotation in Z_q and a translation per seam chain, never a penalty.
#pragma once

#include <vector>

#include "hgp/cut/seam_rotation.h"
#include "hgp/system/row_builder.h"

namespace hgp {

/// One complex unknown per vertex of S (its first copy) and one translation per seam chain, minus
/// what the seam nodes decide:
///   around a non-cone node           the composed translation vanishes;
///   at a cone with rotation ≠ 1      z = T / (1 − R);
///   at a cone with rotation 1        T = 0 and z stays free.
/// Copies follow counterclockwise: z^{s+1} = R z^s + t.
struct ReducedUnknowns {
  int count = 0;
  SparseRows copies;              ///< |V_c| × count: every copy's value
  PerVertex<int> vertexUnknown;   ///< unknown of a vertex, −1 where it is determined
  std::vector<int> chainUnknown;  ///< unknown of a chain's translation, −1 where determined
  PerCutVertex<int> turn;         ///< r_s: copy s turned by e^{i2πr_s/q} against the first (14)
};

ReducedUnknowns reduceUnknowns(const TriMesh& mesh, const CutMesh& cut, const SeamRotations& seams);

/// The other way: the unknowns of a map whose copies follow these seams. Translations are differences of two
/// copies, which are exact where the map is snapped (grid/snap.h).
/// @param z  by copy
Eigen::VectorXcd readUnknowns(const TriMesh& mesh, const CutMesh& cut, const SeamRotations& seams,
                              const ReducedUnknowns& unknowns, const std::vector<Complex>& z);

}  // namespace hgp
