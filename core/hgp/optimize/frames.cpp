#include "hgp/optimize/frames.h"

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

}  // namespace hgp
