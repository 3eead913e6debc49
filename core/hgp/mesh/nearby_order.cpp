#include "hgp/mesh/nearby_order.h"

#include <cstdlib>

namespace hgp {
namespace {

constexpr double kScattered = 0.1;
/// Smaller meshes fit into the processor's caches in any order.
constexpr int kOutOfCache = 20'000;

}  // namespace

bool isScattered(const TriMesh& mesh) {
  if (mesh.faceCount() < kOutOfCache) return false;
  double faces = 0.0, vertices = 0.0;
  for (HalfedgeId h : mesh.halfedges()) {
    vertices += std::abs(mesh.tail(h).i - mesh.head(h).i);
    if (!mesh.isBoundary(h)) faces += std::abs(TriMesh::face(h).i - TriMesh::face(mesh.twin(h)).i);
  }
  const double allowed = kScattered * mesh.halfedgeCount();
  return faces > allowed * mesh.faceCount() || vertices > allowed * mesh.vertexCount();
}

Numbering nearbyNumbering(const TriMesh& mesh) {
  Numbering numbering;
  numbering.vertices.reserve(static_cast<std::size_t>(mesh.vertexCount()));
  numbering.faces.reserve(static_cast<std::size_t>(mesh.faceCount()));
  PerVertex<char> isNumbered(static_cast<std::size_t>(mesh.vertexCount()), 0);
  PerFace<char> isTaken(static_cast<std::size_t>(mesh.faceCount()), 0);
  const auto number = [&](VertexId v) {
    if (isNumbered[v]) return;
    isNumbered[v] = 1;
    numbering.vertices.push_back(v.i);
  };
  std::size_t next = 0;
  const auto finishComponent = [&] {
    for (; next < numbering.vertices.size(); ++next) {
      for (HalfedgeId h : outgoingHalfedges(mesh, VertexId(numbering.vertices[next]))) {
        const FaceId f = TriMesh::face(h);
        if (isTaken[f]) continue;
        isTaken[f] = 1;
        numbering.faces.push_back(f.i);
        for (VertexId v : mesh.corners(f)) number(v);
      }
    }
  };
  for (int n = 0; n < mesh.faceCount(); ++n) {
    number(mesh.corners(mesh.givenFace(n))[0]);
    finishComponent();
  }
  for (VertexId v : mesh.vertices()) number(v);
  return numbering;
}

TriMesh renumbered(const TriMesh& mesh, const Numbering& numbering) {
  PerVertex<int> newVertex(static_cast<std::size_t>(mesh.vertexCount()), -1);
  PerFace<FaceId> newFace(static_cast<std::size_t>(mesh.faceCount()));
  MeshData data;
  data.positions.reserve(numbering.vertices.size());
  for (const int v : numbering.vertices) {
    newVertex[VertexId(v)] = static_cast<int>(data.positions.size());
    data.positions.push_back(mesh.position(VertexId(v)));
  }
  data.triangles.reserve(numbering.faces.size());
  for (const int f : numbering.faces) {
    newFace[FaceId(f)] = FaceId(static_cast<int>(data.triangles.size()));
    const auto corners = mesh.corners(FaceId(f));
    data.triangles.push_back({newVertex[corners[0]], newVertex[corners[1]], newVertex[corners[2]]});
  }
  std::vector<FaceId> given;
  given.reserve(numbering.faces.size());
  for (int n = 0; n < mesh.faceCount(); ++n) given.push_back(newFace[mesh.givenFace(n)]);
  return buildUsableMesh(data, std::move(given));
}

}  // namespace hgp
