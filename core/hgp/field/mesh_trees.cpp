#include "hgp/field/mesh_trees.h"

#include <algorithm>
#include <numeric>

namespace hgp {
namespace {

using linalg::Graph;
using linalg::SeparatorTree;

Graph edgeGraph(const TriMesh& mesh) {
  Graph graph;
  graph.start.assign(static_cast<std::size_t>(mesh.vertexCount()) + 1, 0);
  const auto forEachEnd = [&](auto&& take) {
    for (EdgeId e : mesh.edges()) {
      const HalfedgeId h = mesh.halfedge(e);
      take(mesh.tail(h).i, mesh.head(h).i);
      take(mesh.head(h).i, mesh.tail(h).i);
    }
  };
  forEachEnd([&](int v, int) { ++graph.start[static_cast<std::size_t>(v) + 1]; });
  std::partial_sum(graph.start.begin(), graph.start.end(), graph.start.begin());
  graph.neighbours.resize(static_cast<std::size_t>(graph.start.back()));
  std::vector<int> next(graph.start.begin(), graph.start.end() - 1);
  forEachEnd([&](int v, int w) {
    graph.neighbours[static_cast<std::size_t>(next[static_cast<std::size_t>(v)]++)] = w;
  });
  return graph;
}

/// Where each vertex is eliminated, and the tree's nodes as intervals: the descendants of t are
/// first[t] … t.
struct Places {
  std::vector<int> position, node, first;

  explicit Places(const SeparatorTree& tree)
      : position(tree.order.size()), node(tree.order.size()), first(tree.parent.size()) {
    std::iota(first.begin(), first.end(), 0);
    for (int t = 0; t < tree.nodeCount(); ++t) {
      const auto at = static_cast<std::size_t>(t);
      for (int k = tree.nodeStart[at]; k < tree.nodeStart[at + 1]; ++k) {
        const auto v = static_cast<std::size_t>(tree.order[static_cast<std::size_t>(k)]);
        position[v] = k;
        node[v] = t;
      }
      const int p = tree.parent[at];
      if (p >= 0) {
        int& least = first[static_cast<std::size_t>(p)];
        least = std::min(least, first[at]);
      }
    }
  }

  bool isAncestor(int above, int below) const {
    return first[static_cast<std::size_t>(above)] <= below && below <= above;
  }
};

}  // namespace

SeparatorTree vertexTree(const TriMesh& mesh) { return linalg::nestedDissection(edgeGraph(mesh)); }

SeparatorTree nodeTree(const TriMesh& mesh, const FilledSurface& surface,
                       const SeparatorTree& tree) {
  // Loop nodes come first in the surface and last in a tree that is appended to.
  const int loops = static_cast<int>(surface.loopNode.size());
  const int inner = surface.nodeCount - loops;
  const auto inTree = [&](int node) { return node < loops ? inner + node : node - loops; };
  std::vector<int> keep(tree.order.size(), -1);
  for (VertexId v : mesh.vertices())
    if (surface.node[v] >= loops) keep[static_cast<std::size_t>(v.i)] = inTree(surface.node[v]);
  SeparatorTree nodes = linalg::restrictTree(tree, keep);
  if (loops > 0) {
    std::vector<Eigen::Triplet<double>> spokes;
    for (EdgeId e : mesh.edges()) {
      const HalfedgeId h = mesh.halfedge(e);
      const int a = surface.node[mesh.tail(h)], b = surface.node[mesh.head(h)];
      if (a != b && (a < loops || b < loops)) spokes.emplace_back(inTree(a), inTree(b), 1.0);
    }
    Eigen::SparseMatrix<double> pattern(surface.nodeCount, surface.nodeCount);
    pattern.setFromTriplets(spokes.begin(), spokes.end());
    nodes = linalg::appendVertices(nodes, linalg::graphOf(pattern));
  }
  std::vector<int> name(static_cast<std::size_t>(surface.nodeCount));
  for (int node = 0; node < surface.nodeCount; ++node)
    name[static_cast<std::size_t>(inTree(node))] = node - 1;  // node 0 is held: −1
  return linalg::restrictTree(nodes, name);
}

SeparatorTree faceTree(const TriMesh& mesh, const SeparatorTree& tree) {
  const Places places(tree);
  const auto position = [&](VertexId v) { return places.position[static_cast<std::size_t>(v.i)]; };
  const auto nodeAt = [&](int k) {
    return places.node[static_cast<std::size_t>(tree.order[static_cast<std::size_t>(k)])];
  };
  PerFace<int> first(static_cast<std::size_t>(mesh.faceCount()), 0), node = first;
  for (FaceId f : mesh.faces()) {
    const auto v = mesh.corners(f);
    first[f] = std::min({position(v[0]), position(v[1]), position(v[2])});
    node[f] = nodeAt(first[f]);
  }
  const PerFace<int> lowest = node;
  for (EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e);
    if (mesh.isBoundary(h)) continue;
    const FaceId f = TriMesh::face(h), g = TriMesh::face(mesh.twin(h));
    if (places.isAncestor(lowest[f], lowest[g]) || places.isAncestor(lowest[g], lowest[f]))
      continue;
    // Always the one in the earlier branch, so that one side of a separator moves.
    const FaceId moved = lowest[f] < lowest[g] ? f : g;
    first[moved] = std::min(position(mesh.tail(h)), position(mesh.head(h)));
    node[moved] = nodeAt(first[moved]);
  }
  std::vector<int> order(static_cast<std::size_t>(mesh.faceCount()));
  std::iota(order.begin(), order.end(), 0);
  // Positions grow with nodes: sorting by the first eliminated vertex sorts by node as well.
  std::sort(order.begin(), order.end(), [&](int f, int g) {
    return std::pair(first[FaceId(f)], f) < std::pair(first[FaceId(g)], g);
  });
  SeparatorTree faces;
  faces.parent = tree.parent;
  faces.nodeStart.assign(tree.parent.size() + 1, 0);
  for (FaceId f : mesh.faces()) ++faces.nodeStart[static_cast<std::size_t>(node[f]) + 1];
  std::partial_sum(faces.nodeStart.begin(), faces.nodeStart.end(), faces.nodeStart.begin());
  faces.order = std::move(order);
  return faces;
}

}  // namespace hgp
