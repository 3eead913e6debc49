// Fill-reducing orderings by nested dissection.  Role: the first step of every factorization; one
// dissection of a mesh can serve several matrices over it.
#pragma once

#include <vector>

#include "hgp/linalg/graph/graph.h"

namespace hgp::linalg {

/// A rooted tree of vertex sets: removing a node's ancestors disconnects it from every node that is
/// neither its ancestor nor its descendant. Eliminating in `order` never couples separate branches.
struct SeparatorTree {
  std::vector<int> order;      ///< order[k] is the vertex eliminated k-th; |V| entries
  std::vector<int> nodeStart;  ///< node t holds order[nodeStart[t]] … order[nodeStart[t + 1] − 1]
  std::vector<int> parent;     ///< parent[t] > t; −1 at the single root, which is the last node

  int nodeCount() const { return static_cast<int>(parent.size()); }
};

struct DissectionOptions {
  /// 1: the matrix couples graph neighbours. 2: it also couples vertices at distance two (LᴴL when
  /// the graph is that of L): separators are then two vertices wide, at a third of the cost of
  /// dissecting the squared graph. No other width is allowed (HGP_CHECK).
  int separatorWidth = 1;
  /// Parts of at most this many vertices are ordered by minimum degree. Larger is faster, with a
  /// little more fill; below about 50 nothing is gained.
  int leafSize = 200;
  /// Maximum fraction of the whole in the larger part of a bisection. Larger values allow smaller separators.
  double imbalance = 0.6;
  /// Weight of each vertex in that balance (copies at one vertex, say); empty means all 1.
  std::vector<int> vertexWeights = {};
};

/// Multilevel nested dissection: heavy-edge matching, Fiduccia–Mattheyses refinement, separators as
/// minimum vertex covers of the pairs that cross the cut, leaves by minimum degree seen with their
/// halo. Deterministic: the same graph gives the same tree on every platform. Disconnected graphs,
/// isolated vertices and the empty graph (one empty node) are fine; vertices of extreme degree go to
/// the root.
SeparatorTree nestedDissection(const Graph& graph, const DissectionOptions& options = {});

/// The tree of a graph with further vertices appended (translations, constraints): vertex |V| + i
/// joins the lowest node that keeps the tree valid for the neighbours it has in `graph`, where
/// `tree` orders the first |V| vertices of `graph`. Costs O(edges × depth) at worst.
SeparatorTree appendVertices(const SeparatorTree& tree, const Graph& graph);

/// Restricts a tree to the vertices with keep[v] ≥ 0 and renames v to keep[v] (0 … count − 1).
SeparatorTree restrictTree(const SeparatorTree& tree, const std::vector<int>& keep);

}  // namespace hgp::linalg
