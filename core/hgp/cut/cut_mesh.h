// S_c: S cut along G_s to a disk.  Role: copies v_i^s and edge copies e⁰, e¹ of [BCW17 §4, App. A].
#pragma once

#include <vector>

#include "hgp/cut/seam_graph.h"
#include "hgp/seams/chains.h"

namespace hgp {

/// The faces are those of S; each corner stores which copy of its vertex it uses. An interior seam vertex of
/// degree d in G_s has d copies, a boundary vertex of degree d has d + 1.
struct CutMesh : SeamChains {
  PerEdge<char> isSeam;
  PerHalfedge<CutVertexId> copy;  ///< copy of tail(h) used by face(h)
  PerCutVertex<VertexId> parent;  ///< copies of one vertex are consecutive, counterclockwise
  PerVertex<CutVertexId> firstCopy;

  int vertexCount() const { return parent.size(); }
};

/// @param isSeam  from seamGraph; @param cones  the terminals that are cones
CutMesh cutToDisk(const TriMesh& mesh, PerEdge<char> isSeam, const std::vector<VertexId>& cones);

/// |V_c| − |E_c| + |F| = 1 and connected.
bool isDisk(const TriMesh& mesh, const CutMesh& cut);

}  // namespace hgp
