#include "hgp/cut/seam_rotation.h"

#include "hgp/base/check.h"

namespace hgp {

SeamRotations seamRotations(const TriMesh& mesh, const CutMesh& cut, const FrameField& field) {
  // n_f: the index of the direction that combing picks in face f.
  PerFace<int> n(static_cast<std::size_t>(mesh.faceCount()), -1);
  std::vector<FaceId> stack{FaceId(0)};
  n[FaceId(0)] = 0;
  while (!stack.empty()) {
    const FaceId f = stack.back();
    stack.pop_back();
    for (int k = 0; k < 3; ++k) {
      const HalfedgeId h = TriMesh::halfedge(f, k);
      if (mesh.isBoundary(h) || cut.isSeam[mesh.edge(h)]) continue;
      const FaceId g = TriMesh::face(mesh.twin(h));
      if (n[g] >= 0) continue;
      n[g] = reduceTurn(n[f] + field.matching[h], field.q);
      stack.push_back(g);
    }
  }

  SeamRotations seams;
  seams.q = field.q;
  seams.rotation = PerHalfedge<int>(static_cast<std::size_t>(mesh.halfedgeCount()), 0);
  seams.frameAngle = PerFace<double>(static_cast<std::size_t>(mesh.faceCount()), 0.0);
  for (HalfedgeId h : mesh.halfedges()) {
    if (mesh.isBoundary(h)) continue;
    const FaceId f = TriMesh::face(h), g = TriMesh::face(mesh.twin(h));
    seams.rotation[h] =
        reduceTurn(static_cast<long long>(n[f]) + field.matching[h] - n[g], field.q);
    HGP_CHECK(cut.isSeam[mesh.edge(h)] || seams.rotation[h] == 0,
              "a combed field is continuous off the seam (edge %d)", mesh.edge(h).i);
  }
  for (FaceId f : mesh.faces()) seams.frameAngle[f] = field.angle[f] + turnAngle(n[f], field.q);
  return seams;
}

}  // namespace hgp
