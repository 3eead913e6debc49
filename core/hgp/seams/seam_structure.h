// The seams of a map read from its uv indices: chains, their rotations, and every copy in terms of
// the first copy of its vertex.  Role: (12) of [BCW17] as exact relations, for q = 1, 2, 3, 4, 6.
#pragma once

#include <vector>

#include "hgp/mesh/mesh_data.h"
#include "hgp/seams/relations.h"

namespace hgp {

/// "Copy" is an index into UvMap::uv; every used one belongs to one vertex and one sector between
/// seams. A seam edge is one whose sides use different copies at either end. Turns count e^{i2π/o}, o = Ring::kOrder.
template <class Ring>
struct SeamStructureOver : SeamChains {
  std::vector<int> chainTurn;      ///< z_right = e^{i2π turn/o} z_left + t
  std::vector<VertexId> vertexOf;  ///< per copy; invalid where no corner uses it
  PerVertex<int> firstCopy;        ///< −1 for isolated vertices
  std::vector<int> placeIndex;     ///< per copy: index into `places`, −1 for a vertex off seams
  std::vector<CopyPlace<Ring>> places;
  std::vector<NodeClosure<Ring>> closures;  ///< interior nodes, ascending
  PerHalfedge<int> copy;                    ///< of tail(h), used by face(h)

  /// How copy c is computed from its vertex' first copy and the translations.
  const CopyPlace<Ring>& place(int c) const {
    static const CopyPlace<Ring> same;
    const int p = placeIndex[at(c)];
    return p < 0 ? same : places[at(p)];
  }
};
using SeamStructure = SeamStructureOver<Gaussian>;

/// Rotations are read off each chain's longest edge.
/// @param q       divides Ring::kOrder
/// @param cones   ends of chains, beside branches and the boundary
/// @return nothing where copies are not shared as described above (a sector with two copies, a copy with two
///         sectors, an index out of range), which happens only for maps that hgp did not compute; or for another q
template <class Ring>
std::optional<SeamStructureOver<Ring>> readSeamsOver(const TriMesh& mesh, const UvMap& map, int q,
                                                     const std::vector<VertexId>& cones);

/// For q = 1, 2, 4.
inline std::optional<SeamStructure> readSeams(const TriMesh& mesh, const UvMap& map, int q,
                                              const std::vector<VertexId>& cones) {
  return readSeamsOver<Gaussian>(mesh, map, q, cones);
}

/// t of every chain, z_right − e^{i2π turn/o} z_left, at the tail of its middle edge.
template <class Ring>
std::vector<Complex> chainTranslations(const SeamStructureOver<Ring>& seams, const TriMesh& mesh,
                                       const std::vector<Vec2>& uv);

/// The relations Σ factor · t = 0 of all nodes whose closure has no rotation.
template <class Ring>
std::vector<RingSum<Ring>> closureRelations(const SeamStructureOver<Ring>& seams) {
  std::vector<RingSum<Ring>> relations;
  for (const NodeClosure<Ring>& closure : seams.closures)
    if (closure.place.turn == 0) relations.push_back(closure.place.shift);
  return relations;
}

/// The multiple r of 2π/q for which e^{i2πr/q} a is nearest to the direction of b.
int measuredTurn(const Complex& a, const Complex& b, int q);

}  // namespace hgp
