#include "hgp/cut/cut_mesh.h"

#include "hgp/mesh/face_flood.h"

namespace hgp {
namespace {

void makeCopies(const TriMesh& mesh, CutMesh& cut) {
  cut.copy = PerHalfedge<CutVertexId>(static_cast<std::size_t>(mesh.halfedgeCount()));
  cut.firstCopy = PerVertex<CutVertexId>(static_cast<std::size_t>(mesh.vertexCount()));
  std::vector<VertexId> parent;
  parent.reserve(static_cast<std::size_t>(mesh.vertexCount()));
  for (VertexId v : mesh.vertices()) {
    if (mesh.isIsolated(v)) continue;
    const HalfedgeId first = firstOfSectors(mesh, cut.isSeam, v);
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

}  // namespace

CutMesh cutToDisk(const TriMesh& mesh, PerEdge<char> isSeam, const std::vector<VertexId>& cones) {
  CutMesh cut;
  cut.isSeam = std::move(isSeam);
  makeCopies(mesh, cut);
  static_cast<SeamChains&>(cut) = traceChains(mesh, cut.isSeam, seamNodes(mesh, cut.isSeam, cones));
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
