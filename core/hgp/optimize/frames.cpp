#include "hgp/optimize/frames.h"

#include "hgp/base/portable_math.h"

namespace hgp {

std::vector<FaceId> coneAndBoundaryFaces(const TriMesh& mesh, const std::vector<VertexId>& cones) {
  PerVertex<char> isMarked(static_cast<std::size_t>(mesh.vertexCount()), 0);
  for (VertexId v : cones) isMarked[v] = 1;
  std::vector<FaceId> faces;
  for (FaceId f : mesh.faces())
    for (VertexId v : mesh.corners(f))
      if (isMarked[v] || mesh.isBoundary(v)) {
        faces.push_back(f);
        break;
      }
  if (faces.empty()) faces.push_back(FaceId(0));
  return faces;
}

Frames fieldFrames(const SeamRotations& seams, std::vector<FaceId> faces) {
  Frames frames;
  frames.faces = std::move(faces);
  for (FaceId f : frames.faces) frames.angles.push_back(seams.frameAngle[f]);
  return frames;
}

PerFace<double> framesOfMap(const Geometry& geometry, const CutMesh& cut,
                            const std::vector<Complex>& z) {
  const std::size_t faces = cut.copy.raw().size() / 3;
  PerFace<double> angle(faces, 0.0);
  for (std::size_t i = 0; i < faces; ++i) {
    const FaceId f(static_cast<int>(i));
    const LinearParts parts = linearParts(geometry, f);
    Complex similar = 0.0;
    for (int k = 0; k < 3; ++k)
      similar += parts.similarity[at(k)] * z[at(cut.copy[TriMesh::halfedge(f, k)].i)];
    angle[f] = -portable::arg(similar);
  }
  return angle;
}

}  // namespace hgp
