// The free unknowns of a seamless map.  Role: the seam conditions [BCW17 (12)] are eliminated (a rotation in Z_q and
// a translation per seam chain), so that all values of the unknowns satisfy them; there is no penalty term.
#pragma once

#include <vector>

#include "hgp/cut/seam_rotation.h"
#include "hgp/system/row_builder.h"

namespace hgp {

/// One complex unknown per vertex of S (its first copy) and one translation per seam chain, minus
/// those that the seam nodes determine, with rotation R and translation T composed once around the node:
///   around a non-cone node           T = 0;
///   at a cone with rotation ≠ 1      z = T / (1 − R);
///   at a cone with rotation 1        T = 0 and z stays free.
/// Copies follow counterclockwise: z^{s+1} = R z^s + t.
struct ReducedUnknowns {
  int count = 0;
  SparseRows copies;              ///< |V_c| × count: every copy's value
  PerVertex<int> vertexUnknown;   ///< unknown of a vertex, −1 where it is determined
  std::vector<int> chainUnknown;  ///< unknown of a chain's translation, −1 where determined
  PerCutVertex<int> turn;         ///< r_s of (14): copy s is the first one rotated by e^{i2πr_s/q}
};

ReducedUnknowns reduceUnknowns(const TriMesh& mesh, const CutMesh& cut, const SeamRotations& seams);

/// The inverse of z = copies · x: the unknowns of a map that satisfies these seam conditions. Translations are computed
/// as differences of two copies, which are exact where the map is snapped (grid/snap.h).
/// @param z  per copy, |V_c|
Eigen::VectorXcd readUnknowns(const TriMesh& mesh, const CutMesh& cut, const SeamRotations& seams,
                              const ReducedUnknowns& unknowns, const std::vector<Complex>& z);

/// The terms of z at the corners of a triangle (see gatherFaceRows).
struct CornerCopies {
  const CutMesh& cut;
  const ReducedUnknowns& unknowns;
  FaceId face;

  template <class Visit>
  void operator()(int k, Visit visit) const {
    const int copy = cut.copy[TriMesh::halfedge(face, k)].i;
    for (SparseRows::InnerIterator it(unknowns.copies, copy); it; ++it)
      visit(static_cast<int>(it.col()), it.value());
  }
};

}  // namespace hgp
