// The seams of a map read from its uv indices: chains, their rotations, and every copy in terms of
// the first copy of its vertex.  Role: (12) of [BCW17] as exact integer relations, for q = 1, 2, 4.
#pragma once

#include <vector>

#include "hgp/grid/integer_relations.h"
#include "hgp/mesh/mesh_data.h"
#include "hgp/mesh/tri_mesh.h"

namespace hgp {

/// z = i^turn z_first + Σ factor · t_chain, all coefficients units or sums of units.
struct CopyPlace {
  int turn = 0;
  GaussianSum shift;
};

/// A run of seam edges with the same relation z_right = i^turn z_left + t.
struct TurnedChain {
  int turn = 0;
  std::vector<HalfedgeId> left;  ///< consecutive; their faces see the chain on the left
};

/// Going once counterclockwise around an interior node: z = i^turn z + Σ factor · t must hold again.
struct NodeClosure {
  VertexId vertex;
  CopyPlace place;
};

/// "Copy" is an index into UvMap::uv; every used one belongs to one vertex and one sector between
/// seams. A seam edge is one whose sides use different copies at either end.
struct SeamStructure {
  std::vector<TurnedChain> chains;
  std::vector<VertexId> vertexOf;  ///< per copy; invalid where no corner uses it
  PerVertex<int> firstCopy;        ///< −1 for isolated vertices
  std::vector<int> placeOf;        ///< per copy: index into `places`, −1 for a vertex off seams
  std::vector<CopyPlace> places;
  std::vector<NodeClosure> closures;  ///< interior nodes, ascending
  PerHalfedge<int> copy;              ///< of tail(h), used by face(h)

  int chainCount() const { return static_cast<int>(chains.size()); }
  /// How copy c is computed from its vertex' first copy and the translations.
  const CopyPlace& place(int c) const {
    static const CopyPlace same;
    const int p = placeOf[static_cast<std::size_t>(c)];
    return p < 0 ? same : places[static_cast<std::size_t>(p)];
  }
};

/// Rotations are read off each chain's longest edge.
/// @param q       1, 2 or 4
/// @param cones   ends of chains, beside branches and the boundary
/// @return nothing where copies are not shared as described above (a sector with two copies, an index out of
///         range), which happens only for maps that hgp did not compute
std::optional<SeamStructure> readSeams(const TriMesh& mesh, const UvMap& map, int q,
                                       const std::vector<VertexId>& cones);

/// t of every chain, z_right − i^turn z_left, at its longest edge.
std::vector<Complex> chainTranslations(const SeamStructure& seams, const TriMesh& mesh,
                                       const std::vector<Vec2>& uv);

/// The relations Σ factor · t = 0 of all nodes whose closure has no rotation.
std::vector<GaussianSum> closureRelations(const SeamStructure& seams);

}  // namespace hgp
