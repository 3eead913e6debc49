// The corners between feature edges.  Role: the polygon corners of the patches into which the features Γ cut the
// surface; their indices are the angles of a map whose feature edges are lines u = const or v = const.
#pragma once

#include <vector>

#include "hgp/mesh/tri_mesh.h"

namespace hgp {

/// Consecutive triangles around a vertex of Γ, counterclockwise from one feature edge to the next. In a map along the
/// features its angle is a quarter turn times its index a ≥ 1; n triangles have less than nπ, so that a ≤ 2n − 1.
struct Sector {
  HalfedgeId first;   ///< leaves the vertex along the feature edge where the sector begins
  HalfedgeId last;    ///< enters the vertex along the one where it ends; may be the same edge
  int triangles = 0;  ///< n
};

struct Sectors {
  PerEdge<char> isFeature;
  PerVertex<char> isOnFeature;
  std::vector<Sector> list;
  PerHalfedge<int> of;  ///< the sector of the corner at tail(h); −1 where tail(h) is not on Γ

  /// The node of a corner at tail(h) in one numbering of vertices (first) and sectors.
  int node(const TriMesh& mesh, HalfedgeId h) const {
    return of[h] < 0 ? mesh.tail(h).i : mesh.vertexCount() + of[h];
  }
};

/// @param features  must contain all boundary edges
Sectors findSectors(const TriMesh& mesh, const std::vector<EdgeId>& features);

}  // namespace hgp
