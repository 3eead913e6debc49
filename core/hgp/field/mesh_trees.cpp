#include "hgp/field/mesh_trees.h"

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

}  // namespace

SeparatorTree vertexTree(const TriMesh& mesh, int separatorWidth) {
  linalg::DissectionOptions options;
  options.separatorWidth = separatorWidth;
  return linalg::nestedDissection(edgeGraph(mesh), options);
}

const SeparatorTree& WideTree::get() {
  if (!tree_) tree_ = vertexTree(*mesh_, 2);
  return *tree_;
}

SeparatorTree nodeTree(const TriMesh& mesh, const FilledSurface& surface,
                       const SeparatorTree& tree) {
  // Loop nodes are the first nodes of the surface; the tree has them last, because they are appended.
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
    name[static_cast<std::size_t>(inTree(node))] = node - 1;  // −1, because node 0 is held at 0
  return linalg::restrictTree(nodes, name);
}

}  // namespace hgp
