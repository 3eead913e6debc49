#include "hgp/cut/cut_mesh.h"

#include "hgp/base/check.h"
#include "hgp/mesh/face_flood.h"

namespace hgp {
namespace {

/// A halfedge leaving v at which the counterclockwise sectors start: the first one at the boundary, otherwise a seam
/// edge if there is one.
HalfedgeId firstOfSector(const TriMesh& mesh, const PerEdge<char>& isSeam, VertexId v) {
  if (!mesh.isBoundary(v))
    for (HalfedgeId h : outgoingHalfedges(mesh, v))
      if (isSeam[mesh.edge(h)]) return h;
  return mesh.outgoing(v);
}

void makeCopies(const TriMesh& mesh, CutMesh& cut) {
  cut.copy = PerHalfedge<CutVertexId>(static_cast<std::size_t>(mesh.halfedgeCount()));
  cut.firstCopy = PerVertex<CutVertexId>(static_cast<std::size_t>(mesh.vertexCount()));
  std::vector<VertexId> parent;
  parent.reserve(static_cast<std::size_t>(mesh.vertexCount()));
  for (VertexId v : mesh.vertices()) {
    if (mesh.isIsolated(v)) continue;
    const HalfedgeId first = firstOfSector(mesh, cut.isSeam, v);
    cut.firstCopy[v] = CutVertexId(static_cast<int>(parent.size()));
    parent.push_back(v);
    HalfedgeId h = first;
    do {
      if (h != first && cut.isSeam[mesh.edge(h)]) parent.push_back(v);
      cut.copy[h] = CutVertexId(static_cast<int>(parent.size()) - 1);
      h = mesh.nextOutgoing(h);
    } while (h.isValid() && h != first);
  }
  cut.parent = PerCutVertex<VertexId>(std::move(parent));
}

/// The degree of every vertex in G_s.
PerVertex<int> seamDegree(const TriMesh& mesh, const PerEdge<char>& isSeam) {
  PerVertex<int> degree(static_cast<std::size_t>(mesh.vertexCount()), 0);
  for (EdgeId e : mesh.edges()) {
    if (!isSeam[e]) continue;
    ++degree[mesh.tail(mesh.halfedge(e))];
    ++degree[mesh.head(mesh.halfedge(e))];
  }
  return degree;
}

/// The other seam edge at the head of h, leaving it.
HalfedgeId continueChain(const TriMesh& mesh, const PerEdge<char>& isSeam, HalfedgeId h) {
  for (HalfedgeId out : outgoingHalfedges(mesh, mesh.head(h)))
    if (isSeam[mesh.edge(out)] && mesh.edge(out) != mesh.edge(h)) return out;
  return {};
}

void traceChains(const TriMesh& mesh, CutMesh& cut) {
  cut.chain = PerHalfedge<int>(static_cast<std::size_t>(mesh.halfedgeCount()), -1);
  for (VertexId v : mesh.vertices()) {
    if (!cut.isSeamNode[v]) continue;
    for (HalfedgeId out : outgoingHalfedges(mesh, v)) {
      if (!cut.isSeam[mesh.edge(out)] || cut.chain[out] >= 0) continue;
      SeamChain chain;
      const int id = static_cast<int>(cut.chains.size());
      for (HalfedgeId h = out;; h = continueChain(mesh, cut.isSeam, h)) {
        HGP_CHECK(h.isValid(), "a seam chain ends only at a node");
        chain.left.push_back(h);
        cut.chain[h] = cut.chain[mesh.twin(h)] = id;
        if (cut.isSeamNode[mesh.head(h)]) break;
      }
      cut.chains.push_back(std::move(chain));
    }
  }
}

}  // namespace

CutMesh cutToDisk(const TriMesh& mesh, PerEdge<char> isSeam, const std::vector<VertexId>& cones) {
  CutMesh cut;
  cut.isSeam = std::move(isSeam);
  makeCopies(mesh, cut);
  const PerVertex<int> degree = seamDegree(mesh, cut.isSeam);
  cut.isSeamNode = PerVertex<char>(static_cast<std::size_t>(mesh.vertexCount()), 0);
  for (VertexId v : mesh.vertices())
    cut.isSeamNode[v] = degree[v] > 0 && (degree[v] != 2 || mesh.isBoundary(v));
  for (VertexId v : cones) cut.isSeamNode[v] = 1;
  traceChains(mesh, cut);
  return cut;
}

bool isDisk(const TriMesh& mesh, const CutMesh& cut) {
  int edges = mesh.edgeCount();
  for (char s : cut.isSeam) edges += s;
  if (cut.vertexCount() - edges + mesh.faceCount() != 1) return false;
  PerFace<char> isSeen(static_cast<std::size_t>(mesh.faceCount()), 0);
  isSeen[FaceId(0)] = 1;
  const std::size_t seen = floodFaces(mesh, FaceId(0), [&](HalfedgeId h, FaceId g) {
    if (cut.isSeam[mesh.edge(h)] || isSeen[g]) return false;
    isSeen[g] = 1;
    return true;
  });
  return seen == static_cast<std::size_t>(mesh.faceCount());
}

}  // namespace hgp
