// The graph in which units of index move.  Role: what a node may have and what it costs.
#pragma once

#include <vector>

#include "hgp/features/aligned_field.h"

namespace hgp {

/// Cost of a path per edge, relative to the costs of nodes.
inline constexpr double kEdgeCost = 0.05;
/// Costs of nodes: kSectorCost (a − angle/(π/2))² for sectors, |k − 4| for vertices off Γ.
inline constexpr double kSectorCost = 10.0;
/// Cost of an index per unit beyond its bounds.
inline constexpr double kImpossible = 1e6;
/// Whether a change of costs leads to an index beyond its bounds.
inline bool isImpossible(double change) { return change > 0.5 * kImpossible; }

/// Nodes are vertices off Γ and sectors (Sectors::node); the edges of a node's corners lead to its neighbours. Keeps references.
class IndexGraph {
 public:
  IndexGraph(const TriMesh& mesh, const Geometry& geometry, const AlignedField& field);

  const TriMesh& mesh() const { return mesh_; }
  int count() const { return static_cast<int>(angle_.size()); }
  bool exists(int n) const;
  VertexId vertexOf(int n) const;
  double angle(int n) const { return angle_[at(n)]; }  ///< sum of the corners' angles
  bool isSector(int n) const { return n >= mesh_.vertexCount(); }
  /// The nodes of a vertex on Γ.
  const std::vector<int>& sectorsAt(VertexId v) const { return sectorsAt_[v]; }

  int index(int n) const { return field_.index[at(n)]; }
  int given(int n) const { return field_.given.node.empty() ? 0 : field_.given.node[at(n)]; }
  int lowest(int n) const { return given(n) != 0 ? given(n) : 1; }
  int largest(int n) const { return given(n) != 0 ? given(n) : bound(n); }
  /// Whether a prescribed index is one that the triangles can have.
  bool canHold(int n) const { return lowest(n) >= 1 && lowest(n) <= bound(n); }
  /// The change of the cost of a node that is given `units`.
  double changeOf(int n, int units) const { return cost(n, index(n) + units) - cost(n, index(n)); }

  /// Calls use(h, isForward, neighbour) for every step from node n: along halfedge h from its tail, or backwards.
  template <class Use>
  void forSteps(int n, const Use& use) const {
    const Sectors& sectors = field_.sectors;
    const auto corner = [&](HalfedgeId h) {
      const HalfedgeId into = TriMesh::previous(h);
      use(h, true, sectors.node(mesh_, TriMesh::next(h)));
      // A feature edge that ends the sector is a step on this side alone; others are seen from the next corner.
      if (sectors.isFeature[mesh_.edge(into)]) use(into, false, sectors.node(mesh_, into));
    };
    if (n < mesh_.vertexCount()) {
      for (HalfedgeId h : outgoingHalfedges(mesh_, VertexId(n))) corner(h);
      return;
    }
    HalfedgeId h = sectors.list[at(n - mesh_.vertexCount())].first;
    for (;; h = mesh_.twin(TriMesh::previous(h))) {
      corner(h);
      if (sectors.isFeature[mesh_.edge(TriMesh::previous(h))]) return;
    }
  }

 private:
  int bound(int n) const { return largestIndex(mesh_, field_.sectors, n); }
  double cost(int n, int value) const;

  const TriMesh& mesh_;
  const AlignedField& field_;
  std::vector<double> angle_;
  PerVertex<std::vector<int>> sectorsAt_;
};

}  // namespace hgp
