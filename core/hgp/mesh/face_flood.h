// Breadth-first traversal of faces across edges.  Role: components, dual trees and combing all use it.
#pragma once

#include <vector>

#include "hgp/mesh/tri_mesh.h"

namespace hgp {

/// Breadth first from `seed`. `enter(h, g)` is called for every interior halfedge h of a face that was reached, with
/// the face g across h, and returns whether g is now reached through h. It must itself remember which faces were
/// reached, including the seed.
/// @return the number of faces that were reached
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
