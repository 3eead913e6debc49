#include "hgp/mesh/topology.h"

#include <algorithm>

#include "hgp/base/check.h"
#include "hgp/base/disjoint_sets.h"
#include "hgp/mesh/face_flood.h"

namespace hgp {
namespace {

void findComponents(const TriMesh& mesh, Topology& topology) {
  topology.component = PerFace<int>(static_cast<std::size_t>(mesh.faceCount()), -1);
  for (FaceId seed : mesh.faces()) {
    if (topology.component[seed] >= 0) continue;
    const int id = topology.componentCount++;
    topology.component[seed] = id;
    floodFaces(mesh, seed, [&](HalfedgeId, FaceId g) {
      const bool isNew = topology.component[g] < 0;
      if (isNew) topology.component[g] = id;
      return isNew;
    });
  }
}

std::vector<BoundaryLoop> findLoops(const TriMesh& mesh) {
  std::vector<BoundaryLoop> loops;
  PerHalfedge<char> isSeen(static_cast<std::size_t>(mesh.halfedgeCount()), 0);
  for (int n = 0; n < mesh.halfedgeCount(); ++n) {
    const HalfedgeId start = mesh.givenHalfedge(n);
    if (!mesh.isBoundary(start) || isSeen[start]) continue;
    BoundaryLoop loop;
    for (HalfedgeId h = start; !isSeen[h]; h = mesh.outgoing(mesh.head(h))) {
      isSeen[h] = 1;
      loop.halfedges.push_back(h);
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

/// The halfedge through which breadth-first search over faces first entered each face (the crossed
/// halfedge of the parent face); primal tree edges are not crossed.
struct DualTree {
  PerFace<HalfedgeId> entry;
  PerFace<int> depth;
  PerEdge<char> isCrossed;
};

DualTree growDualTree(const TriMesh& mesh, const PerEdge<char>& isPrimalTree) {
  DualTree tree{PerFace<HalfedgeId>(static_cast<std::size_t>(mesh.faceCount())),
                PerFace<int>(static_cast<std::size_t>(mesh.faceCount()), -1),
                PerEdge<char>(static_cast<std::size_t>(mesh.edgeCount()), 0)};
  tree.depth[mesh.givenFace(0)] = 0;
  floodFaces(mesh, mesh.givenFace(0), [&](HalfedgeId h, FaceId g) {
    if (isPrimalTree[mesh.edge(h)] || tree.depth[g] >= 0) return false;
    tree.depth[g] = tree.depth[TriMesh::face(h)] + 1;
    tree.entry[g] = h;
    tree.isCrossed[mesh.edge(h)] = 1;
    return true;
  });
  return tree;
}

/// The closed walk root → face(h) → across h → root of the dual tree, without the common part.
DualLoop closeLoop(const TriMesh& mesh, const DualTree& tree, HalfedgeId h) {
  std::vector<HalfedgeId> down, up;
  FaceId a = TriMesh::face(h), b = TriMesh::face(mesh.twin(h));
  while (a != b) {
    if (tree.depth[a] >= tree.depth[b]) {
      down.push_back(tree.entry[a]);
      a = TriMesh::face(tree.entry[a]);
    } else {
      up.push_back(mesh.twin(tree.entry[b]));
      b = TriMesh::face(tree.entry[b]);
    }
  }
  DualLoop loop;
  loop.crossed.assign(down.rbegin(), down.rend());
  loop.crossed.push_back(h);
  loop.crossed.insert(loop.crossed.end(), up.begin(), up.end());
  return loop;
}

}  // namespace

Topology computeTopology(const TriMesh& mesh) {
  Topology topology;
  findComponents(mesh, topology);
  topology.loops = findLoops(mesh);
  for (VertexId v : mesh.vertices()) topology.isolatedVertexCount += mesh.isIsolated(v);
  topology.eulerCharacteristic =
      mesh.vertexCount() - topology.isolatedVertexCount - mesh.edgeCount() + mesh.faceCount();
  topology.genus = (2 * topology.componentCount - static_cast<int>(topology.loops.size()) -
                    topology.eulerCharacteristic) /
                   2;
  return topology;
}

std::vector<DualLoop> handleGenerators(const TriMesh& mesh) {
  // Boundary loops are filled in: all vertices of a loop count as one, and the loop's own edges are
  // neither crossed nor needed. What remains after a primal spanning tree and a dual spanning tree
  // of the rest are exactly 2g edges.
  DisjointSets forest(mesh.vertexCount());
  PerEdge<char> isPrimalTree(static_cast<std::size_t>(mesh.edgeCount()), 0);
  for (EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e);
    if (!mesh.isBoundary(h)) continue;
    forest.join(mesh.tail(h).i, mesh.head(h).i);
    isPrimalTree[e] = 1;
  }
  // The dual tree first (breadth-first, so loops stay short), then the primal tree of the rest.
  const DualTree dual = growDualTree(mesh, isPrimalTree);
  std::vector<DualLoop> loops;
  for (int n = 0; n < mesh.halfedgeCount(); ++n) {
    const HalfedgeId h = mesh.givenHalfedge(n);
    const EdgeId e = mesh.edge(h);
    if (isPrimalTree[e] || dual.isCrossed[e]) continue;
    isPrimalTree[e] = 1;  // edges are visited from both sides but count once
    if (!forest.join(mesh.tail(h).i, mesh.head(h).i)) loops.push_back(closeLoop(mesh, dual, h));
  }
  return loops;
}

std::vector<Component> splitComponents(const MeshData& data, const TriMesh& mesh,
                                       const Topology& topology) {
  std::vector<Component> parts(static_cast<std::size_t>(topology.componentCount));
  for (FaceId f : mesh.faces())
    parts[static_cast<std::size_t>(topology.component[f])].faceOrigin.push_back(f.i);
  std::vector<int> local(data.positions.size(), -1);
  for (Component& part : parts) {
    for (int f : part.faceOrigin)
      for (int v : data.triangles[static_cast<std::size_t>(f)]) part.vertexOrigin.push_back(v);
    std::sort(part.vertexOrigin.begin(), part.vertexOrigin.end());
    part.vertexOrigin.erase(std::unique(part.vertexOrigin.begin(), part.vertexOrigin.end()),
                            part.vertexOrigin.end());
    for (std::size_t n = 0; n < part.vertexOrigin.size(); ++n) {
      const auto v = static_cast<std::size_t>(part.vertexOrigin[n]);
      local[v] = static_cast<int>(n);
      part.mesh.positions.push_back(data.positions[v]);
    }
    for (int f : part.faceOrigin) {
      const auto& t = data.triangles[static_cast<std::size_t>(f)];
      part.mesh.triangles.push_back({local[static_cast<std::size_t>(t[0])],
                                     local[static_cast<std::size_t>(t[1])],
                                     local[static_cast<std::size_t>(t[2])]});
    }
  }
  return parts;
}

}  // namespace hgp
