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

LinearParts linearParts(const Geometry& geometry, FaceId f) {
  const auto& p = geometry.corner[f];
  LinearParts parts;
  for (std::size_t k = 0; k < 3; ++k) {
    // ∇φ_k is the opposite edge turned by a quarter and divided by twice the area.
    const Complex gradient =
        Complex(0, 1) * (p[(k + 2) % 3] - p[(k + 1) % 3]) / (2.0 * geometry.area[f]);
    parts.antisimilarity[k] = 0.5 * gradient;
    parts.similarity[k] = 0.5 * std::conj(gradient);
  }
  return parts;
}

std::vector<FaceId> growFaces(const TriMesh& mesh, const std::vector<FaceId>& faces, int rings) {
  PerVertex<char> isMarked(static_cast<std::size_t>(mesh.vertexCount()), 0);
  std::vector<FaceId> grown = faces;
  for (int ring = 0; ring < rings; ++ring) {
    for (FaceId f : grown)
      for (VertexId v : mesh.corners(f)) isMarked[v] = 1;
    grown.clear();
    for (FaceId f : mesh.faces())
      for (VertexId v : mesh.corners(f))
        if (isMarked[v]) {
          grown.push_back(f);
          break;
        }
  }
  return grown;
}

}  // namespace hgp
