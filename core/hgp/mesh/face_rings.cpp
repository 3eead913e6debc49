#include "hgp/mesh/face_rings.h"

#include <algorithm>

namespace hgp {

std::vector<FaceId> growFaces(const TriMesh& mesh, const std::vector<FaceId>& faces, int rings) {
  PerFace<char> isIn(at(mesh.faceCount()), 0);
  std::vector<FaceId> all = faces, front = faces;
  for (FaceId f : faces) isIn[f] = 1;
  for (int ring = 0; ring < rings; ++ring) {
    std::vector<FaceId> next;
    for (FaceId f : front)
      for (VertexId v : mesh.corners(f))
        for (HalfedgeId h : outgoingHalfedges(mesh, v)) {
          const FaceId g = TriMesh::face(h);
          if (isIn[g]) continue;
          isIn[g] = 1;
          next.push_back(g);
        }
    all.insert(all.end(), next.begin(), next.end());
    front = std::move(next);
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

std::vector<std::vector<FaceId>> patchesAround(const TriMesh& mesh,
                                               const std::vector<FaceId>& faces, int rings) {
  std::vector<std::vector<FaceId>> patches;
  const std::vector<FaceId> all = growFaces(mesh, faces, rings);
  PerFace<char> isLeft(at(mesh.faceCount()), 0);
  for (FaceId f : all) isLeft[f] = 1;
  for (FaceId first : all) {
    if (!isLeft[first]) continue;
    std::vector<FaceId> patch{first};
    isLeft[first] = 0;
    for (std::size_t n = 0; n < patch.size(); ++n)
      for (VertexId v : mesh.corners(patch[n]))
        for (HalfedgeId h : outgoingHalfedges(mesh, v)) {
          const FaceId g = TriMesh::face(h);
          if (!isLeft[g]) continue;
          isLeft[g] = 0;
          patch.push_back(g);
        }
    std::sort(patch.begin(), patch.end());
    patches.push_back(std::move(patch));
  }
  return patches;
}

}  // namespace hgp
