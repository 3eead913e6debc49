#include "hgp/features/feature_splits.h"

#include <algorithm>
#include <array>

#include "hgp/mesh/vectors.h"

namespace hgp {
namespace {

PerEdge<char> markEdges(const TriMesh& mesh, const std::vector<EdgeId>& edges) {
  PerEdge<char> isMarked(at(mesh.edgeCount()), 0);
  for (EdgeId e : edges) isMarked[e] = 1;
  return isMarked;
}

PerVertex<char> verticesOf(const TriMesh& mesh, const std::vector<EdgeId>& edges) {
  PerVertex<char> isEnd(at(mesh.vertexCount()), 0);
  for (EdgeId e : edges) {
    const HalfedgeId h = mesh.halfedge(e);
    isEnd[mesh.tail(h)] = isEnd[mesh.head(h)] = 1;
  }
  return isEnd;
}

std::array<EdgeId, 3> edgesOf(const TriMesh& mesh, FaceId f) {
  return {mesh.edge(TriMesh::halfedge(f, 0)), mesh.edge(TriMesh::halfedge(f, 1)),
          mesh.edge(TriMesh::halfedge(f, 2))};
}

double lengthOf(const TriMesh& mesh, EdgeId e) {
  const HalfedgeId h = mesh.halfedge(e);
  return distance(mesh.position(mesh.tail(h)), mesh.position(mesh.head(h)));
}

std::vector<EdgeId> listed(const TriMesh& mesh, const PerEdge<char>& isMarked) {
  std::vector<EdgeId> edges;
  for (EdgeId e : mesh.edges())
    if (isMarked[e]) edges.push_back(e);
  return edges;
}

}  // namespace

std::vector<EdgeId> edgesOfCrowded(const TriMesh& mesh, const std::vector<EdgeId>& features) {
  const PerEdge<char> isFeature = markEdges(mesh, features);
  PerFace<char> isOpen(at(mesh.faceCount()), 0);
  for (FaceId f : mesh.faces()) {
    const std::array<EdgeId, 3> edges = edgesOf(mesh, f);
    isOpen[f] =
        std::all_of(edges.begin(), edges.end(), [&](EdgeId e) { return isFeature[e] != 0; });
  }
  const auto openAt = [&](EdgeId e) {
    const HalfedgeId h = mesh.halfedge(e), twin = mesh.twin(h);
    return isOpen[TriMesh::face(h)] + (twin.isValid() ? isOpen[TriMesh::face(twin)] : 0);
  };
  PerEdge<char> isSplit(at(mesh.edgeCount()), 0);
  for (FaceId f : mesh.faces()) {
    if (!isOpen[f]) continue;
    const std::array<EdgeId, 3> edges = edgesOf(mesh, f);
    const EdgeId best = *std::max_element(edges.begin(), edges.end(), [&](EdgeId a, EdgeId b) {
      return openAt(a) != openAt(b) ? openAt(a) < openAt(b) : lengthOf(mesh, a) < lengthOf(mesh, b);
    });
    isSplit[best] = 1;
    const HalfedgeId h = mesh.halfedge(best), twin = mesh.twin(h);
    isOpen[TriMesh::face(h)] = 0;
    if (twin.isValid()) isOpen[TriMesh::face(twin)] = 0;
  }
  return listed(mesh, isSplit);
}

std::vector<EdgeId> chords(const TriMesh& mesh, const std::vector<EdgeId>& features) {
  const PerVertex<char> isOn = verticesOf(mesh, features);
  const PerEdge<char> isFeature = markEdges(mesh, features);
  PerEdge<char> isChord(at(mesh.edgeCount()), 0);
  for (EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e);
    isChord[e] = !isFeature[e] && isOn[mesh.tail(h)] && isOn[mesh.head(h)];
  }
  return listed(mesh, isChord);
}

std::vector<EdgeId> edgesAround(const TriMesh& mesh, const std::vector<EdgeId>& features) {
  const PerVertex<char> isOn = verticesOf(mesh, features);
  PerEdge<char> isNear(at(mesh.edgeCount()), 0);
  for (FaceId f : mesh.faces()) {
    const auto corners = mesh.corners(f);
    if (std::none_of(corners.begin(), corners.end(), [&](VertexId v) { return isOn[v] != 0; }))
      continue;
    for (EdgeId e : edgesOf(mesh, f)) isNear[e] = 1;
  }
  return listed(mesh, isNear);
}

}  // namespace hgp
