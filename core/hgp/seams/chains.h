// Seam edges in chains between nodes.  Role: all edges of a chain have the same rotation and translation in
// [BCW17 (12)], so that a chain is one unknown.
#pragma once

#include <vector>

#include "hgp/mesh/tri_mesh.h"

namespace hgp {

/// A run of seam edges between two seam nodes.
struct SeamChain {
  std::vector<HalfedgeId> left;  ///< consecutive halfedges; their faces see the chain on the left
};

struct SeamChains {
  std::vector<SeamChain> chains;
  PerHalfedge<int> chain;      ///< chain of a seam halfedge, −1 elsewhere
  PerHalfedge<char> isLeft;    ///< of a seam halfedge: it is one of SeamChain::left
  PerVertex<char> isSeamNode;  ///< the ends of chains

  int chainCount() const { return static_cast<int>(chains.size()); }
};

/// Vertices on seams whose degree in G_s is not 2, or that are cones or on the boundary.
PerVertex<char> seamNodes(const TriMesh& mesh, const PerEdge<char>& isSeam,
                          const std::vector<VertexId>& cones);

/// Every seam edge belongs to exactly one chain. A closed chain without a node gets one: the tail of its lowest edge.
/// @pre seam edges are interior edges
SeamChains traceChains(const TriMesh& mesh, const PerEdge<char>& isSeam, PerVertex<char> isNode);

/// The chain of each of these seam edges, numbered from 0 in the order of the edges; chains also end where the rotation
/// changes.
/// @param turn  by seam edge, its r ∈ Z_q; r and q − r are the same, as the choice of the first side is arbitrary
std::vector<int> chainsOfEdges(const TriMesh& mesh, const std::vector<EdgeId>& edges,
                               const std::vector<int>& turn, int q);

/// A halfedge leaving v at which its sectors start, counterclockwise: the first one at the boundary, otherwise a seam
/// edge if there is one.
HalfedgeId firstOfSectors(const TriMesh& mesh, const PerEdge<char>& isSeam, VertexId v);

}  // namespace hgp
