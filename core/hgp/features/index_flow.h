// Moves units of index between sectors and vertices.  Role: makes the indices of an aligned field possible: a ≥ 1, and
// no more than the triangles hold.
#pragma once

#include <utility>
#include <vector>

#include "hgp/features/aligned_field.h"

namespace hgp {

/// While a node has an index below 1 or above largestIndex(), or not the given one, moves a unit along the cheapest path of edges of its patch
/// to or from the node where that costs least: a unit that moves along an edge changes the matching across it by one, or
/// the axis on this side of a feature edge, so that all equations of AlignedField stay true and Gauss–Bonnet holds on
/// every patch. Costs are those of IndexGraph.
/// Fails with kPrescription, and the places, where a patch has no node that can give or take a unit.
Status makeIndicesPossible(const TriMesh& mesh, const Geometry& geometry, AlignedField& field);

/// Cancels pairs of vertices off Γ with k < 4 and k > 4 between which no feature is, where the surface is flat: within half of
/// their distance around each of them there is less than π/8 of the curvature that its cone would take up. Such pairs come from
/// the triangulation. @return how many
int cancelFlatPairs(const TriMesh& mesh, const Geometry& geometry, AlignedField& field);

/// Moves `units` from the node at tail(h) to the node at head(h), along h or, if it is a feature, along this side of it. The
/// angles of the field do not change: turns and tilts do, until fitField().
void moveUnit(const TriMesh& mesh, HalfedgeId h, int units, AlignedField& field);

/// A unit that moves from node to node: one unit along each of these halfedges, or back (−1).
struct IndexMove {
  std::vector<std::pair<HalfedgeId, int>> steps;
  double cost = 0.0;  ///< change of the costs of both ends, and of the path
};

/// The cheapest moves that give a unit to `node` (sign 1) or take one from it (−1), cheapest first, at most `most`. Both
/// ends have possible indices afterwards.
std::vector<IndexMove> cheapestMoves(const TriMesh& mesh, const Geometry& geometry,
                                     AlignedField& field, int node, int sign, std::size_t most);

void applyMove(const TriMesh& mesh, const IndexMove& move, AlignedField& field);

}  // namespace hgp
