#include "hgp/cut/seam_rotation.h"

#include "hgp/base/check.h"
#include "hgp/mesh/face_flood.h"

namespace hgp {

SeamRotations seamRotations(const TriMesh& mesh, const CutMesh& cut, const FrameField& field) {
  // n_f: the index of the direction that combing picks in face f.
  PerFace<int> n(static_cast<std::size_t>(mesh.faceCount()), -1);
  n[FaceId(0)] = 0;
  floodFaces(mesh, FaceId(0), [&](HalfedgeId h, FaceId g) {
    if (cut.isSeam[mesh.edge(h)] || n[g] >= 0) return false;
    const FaceId f = TriMesh::face(h);
    n[g] = reduceTurn(n[f] + field.matching[h], field.q);
    return true;
  });

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
