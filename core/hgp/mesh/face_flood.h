// The faces that are reached from one of them.  Role: components, dual trees and combing walk alike.
#pragma once

#include <vector>

#include "hgp/mesh/tri_mesh.h"

namespace hgp {

/// Breadth first from `seed`. `enter(h, g)` is asked for every halfedge h of a face that was reached and the
/// face g across it (a boundary has none), and says whether g is now reached through h; it keeps record of the
/// faces that were reached, the seed included.
/// @return how many were reached
template <class Enter>
std::size_t floodFaces(const TriMesh& mesh, FaceId seed, const Enter& enter) {
  std::vector<FaceId> reached{seed};
  for (std::size_t i = 0; i < reached.size(); ++i) {
    const FaceId f = reached[i];
    for (int k = 0; k < 3; ++k) {
      const HalfedgeId h = TriMesh::halfedge(f, k);
      if (mesh.isBoundary(h)) continue;
      const FaceId g = TriMesh::face(mesh.twin(h));
      if (enter(h, g)) reached.push_back(g);
    }
  }
  return reached.size();
}

}  // namespace hgp
