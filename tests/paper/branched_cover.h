// The q-fold branched cover S̃_q of [BCW17 §5] and index counting on it [§6].  Role: the paper's proof
// acted out; the method itself never builds it.
#pragma once

#include <vector>

#include "hgp/cut/seam_rotation.h"
#include "hgp/field/prescribed_field.h"
#include "hgp/mesh/topology.h"

namespace hgp::test {

/// q copies of S_c, glued where the images of edge copies under f_n = e^{2πin/q} f are parallel.
struct BranchedCover {
  TriMesh mesh;  ///< face n·|F| + f is the copy of face f on sheet n
  Topology topology;
  int sheets = 1;
  std::vector<VertexId> projection;    ///< P_q on vertices
  std::vector<LoopId> loopProjection;  ///< boundary loop of the cover → loop of S
};
BranchedCover branchedCover(const TriMesh& mesh, const SeamRotations& seams);

/// Edge vectors of the cover under the maps f_n, one per halfedge: dz[h of sheet n] = e^{2πin/q} dz[h].
std::vector<Complex> liftedEdges(const BranchedCover& cover, const CutMesh& cut,
                                 const std::vector<Complex>& z);

/// Indices of the 1-form ρ^{α,β} = α Re dz + β Im dz on the cover closed by exterior faces [§3.2]:
/// 1 − (sign changes)/2, per vertex, per face and per exterior face.
struct Indices {
  std::vector<int> vertex, face, exterior;
  int sum() const;
};
Indices countIndices(const BranchedCover& cover, const std::vector<Complex>& edges, double alpha,
                     double beta);

}  // namespace hgp::test
