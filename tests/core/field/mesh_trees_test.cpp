#include "hgp/field/mesh_trees.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/shapes.h"

namespace hgp {
namespace {

using linalg::SeparatorTree;

/// Node of every entry, −1 where an entry is missing or listed twice.
std::vector<int> nodesOf(const SeparatorTree& tree, int count) {
  std::vector<int> node(static_cast<std::size_t>(count), -1);
  EXPECT_EQ(static_cast<int>(tree.order.size()), count);
  EXPECT_EQ(tree.nodeStart.size(), tree.parent.size() + 1);
  for (int t = 0; t < tree.nodeCount(); ++t)
    for (int k = tree.nodeStart[t]; k < tree.nodeStart[t + 1]; ++k) {
      EXPECT_EQ(node[tree.order[k]], -1) << "listed twice";
      node[tree.order[k]] = t;
    }
  EXPECT_EQ(std::count(node.begin(), node.end(), -1), 0);
  return node;
}

bool areRelated(const SeparatorTree& tree, int a, int b) {
  for (int t = a; t >= 0; t = tree.parent[t])
    if (t == b) return true;
  for (int t = b; t >= 0; t = tree.parent[t])
    if (t == a) return true;
  return false;
}

/// Large enough for several levels of separators.
std::vector<test::Shape> shapes() {
  std::vector<test::Shape> list = test::all();
  list.push_back(test::icosphere(12));
  list.push_back(test::torus(40, 30));
  list.push_back(test::pretzel(3, 6));
  list.push_back(test::cylinder(40, 20));
  list.push_back(test::disk(20));
  return list;
}

TEST(MeshTrees, NeighboursAreNeverInSeparateBranches) {
  for (const test::Shape& shape : shapes()) {
    const TriMesh mesh = shape.mesh();
    const SeparatorTree vertices = vertexTree(mesh);
    const FilledSurface surface = fillBoundary(mesh, computeTopology(mesh), computeGeometry(mesh));
    const SeparatorTree nodes = nodeTree(mesh, surface, vertices);
    const std::vector<int> atVertex = nodesOf(vertices, mesh.vertexCount());
    const std::vector<int> atNode = nodesOf(nodes, surface.nodeCount - 1);
    for (EdgeId e : mesh.edges()) {
      const HalfedgeId h = mesh.halfedge(e);
      const VertexId a = mesh.tail(h), b = mesh.head(h);
      ASSERT_TRUE(areRelated(vertices, atVertex[a.i], atVertex[b.i])) << shape.name;
      const int m = surface.node[a] - 1, n = surface.node[b] - 1;
      if (m >= 0 && n >= 0) {
        ASSERT_TRUE(areRelated(nodes, atNode[m], atNode[n])) << shape.name;
      }
    }
  }
}

}  // namespace
}  // namespace hgp
