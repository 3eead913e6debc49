#include "hgp/field/filled_surface.h"

#include <gtest/gtest.h>

#include <set>

#include "hgp/field/mesh_trees.h"
#include "hgp/field/prescribed_field.h"
#include "support/prescriptions.h"
#include "support/shapes.h"

namespace hgp {
namespace {

TEST(FilledSurface, CurvatureSumsToThatOfTheClosedSurface) {
  for (const test::Shape& shape : test::all()) {
    const TriMesh mesh = shape.mesh();
    const FilledSurface surface = fillBoundary(mesh, computeTopology(mesh), computeGeometry(mesh));
    double sum = 0.0;
    for (double K : surface.curvature) sum += K;
    EXPECT_NEAR(sum, 2 * kPi * (2 - 2 * shape.genus), 1e-9) << shape.name;
  }
}

TEST(FilledSurface, EachLoopAndEachInteriorVertexIsOneNode) {
  for (const test::Shape& shape : test::all()) {
    const TriMesh mesh = shape.mesh();
    const Topology topology = computeTopology(mesh);
    const FilledSurface surface = fillBoundary(mesh, topology, computeGeometry(mesh));
    ASSERT_EQ(surface.loopNode.size(), topology.loops.size());
    std::set<int> nodes(surface.loopNode.begin(), surface.loopNode.end());
    for (std::size_t j = 0; j < topology.loops.size(); ++j)
      for (HalfedgeId h : topology.loops[j].halfedges)
        EXPECT_EQ(surface.node[mesh.tail(h)], surface.loopNode[j]) << shape.name;
    for (VertexId v : mesh.vertices()) {
      EXPECT_EQ(surface.isInterior(mesh, v), !mesh.isBoundary(v)) << shape.name;
      if (!mesh.isBoundary(v)) {
        EXPECT_TRUE(nodes.insert(surface.node[v]).second) << shape.name;
      }
    }
    EXPECT_EQ(static_cast<int>(nodes.size()), surface.nodeCount) << shape.name;
  }
}

TEST(FilledSurface, WeightsArePositiveInsideAndZeroOnTheBoundary) {
  for (const test::Shape& shape : test::all()) {
    const TriMesh mesh = shape.mesh();
    const FilledSurface surface = fillBoundary(mesh, computeTopology(mesh), computeGeometry(mesh));
    for (EdgeId e : mesh.edges()) {
      if (mesh.isBoundary(mesh.halfedge(e))) {
        EXPECT_EQ(surface.weight[e], 0.0);
      } else
        EXPECT_GT(surface.weight[e], 0.0);
    }
  }
}

TEST(SurfaceLaplacian, SolvesItsEquationWithNodeZeroHeld) {
  std::mt19937 random(3);
  for (const test::Shape& shape : test::all()) {
    const TriMesh mesh = shape.mesh();
    const FilledSurface surface = fillBoundary(mesh, computeTopology(mesh), computeGeometry(mesh));
    const Result<SurfaceLaplacian> laplacian =
        SurfaceLaplacian::build(mesh, surface, vertexTree(mesh));
    ASSERT_TRUE(laplacian) << shape.name;
    Eigen::MatrixXd rhs(surface.nodeCount, 2);
    for (Eigen::Index i = 0; i < rhs.size(); ++i) rhs.data()[i] = test::randomReal(random);
    rhs.rowwise() -= rhs.colwise().mean().eval();
    const Eigen::MatrixXd u = laplacian->solve(rhs);
    EXPECT_EQ(u.row(0).norm(), 0.0) << shape.name;
    Eigen::MatrixXd Lu = Eigen::MatrixXd::Zero(surface.nodeCount, 2);
    for (EdgeId e : mesh.edges()) {
      const int a = surface.node[mesh.tail(mesh.halfedge(e))];
      const int b = surface.node[mesh.head(mesh.halfedge(e))];
      Lu.row(a) += surface.weight[e] * (u.row(a) - u.row(b));
      Lu.row(b) += surface.weight[e] * (u.row(b) - u.row(a));
    }
    EXPECT_LT((Lu - rhs).norm(), 1e-10 * (1.0 + rhs.norm())) << shape.name;
  }
}

}  // namespace
}  // namespace hgp
