#include "hgp/mesh/refine.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "hgp/mesh/topology.h"
#include "support/random.h"
#include "support/shapes.h"

namespace hgp {
namespace {

double areaOf(const MeshData& data) {
  double sum = 0.0;
  for (const auto& t : data.triangles) {
    const Vec3 &a = data.positions[std::size_t(t[0])], &b = data.positions[std::size_t(t[1])],
               &c = data.positions[std::size_t(t[2])];
    Vec3 n{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      n[i] = (b[j] - a[j]) * (c[k] - a[k]) - (b[k] - a[k]) * (c[j] - a[j]);
    }
    sum += 0.5 * std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  }
  return sum;
}

/// A third of the edges, and with them triangles with no, one, two and three split edges.
std::vector<VertexPair> someEdges(const TriMesh& mesh, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<VertexPair> edges;
  for (EdgeId e : mesh.edges())
    if (random() % 3 == 0)
      edges.push_back({mesh.tail(mesh.halfedge(e)).i, mesh.head(mesh.halfedge(e)).i});
  return edges;
}

TEST(SplitEdges, GivesAConformingMeshOfTheSameShapeAndTopology) {
  for (const test::Shape& shape : test::all()) {
    const TriMesh mesh = shape.mesh();
    const auto edges = someEdges(mesh, 3);
    const RefinedMesh refined = splitEdges(shape.data, edges);
    EXPECT_EQ(refined.parents.size(), edges.size()) << shape.name;
    EXPECT_EQ(refined.mesh.positions.size(), shape.data.positions.size() + edges.size());
    const auto after = buildTriMesh(refined.mesh, true);
    ASSERT_TRUE(after.hasValue()) << shape.name << ": " << after.error().message;
    const Topology topology = computeTopology(*after);
    EXPECT_EQ(topology.genus, shape.genus) << shape.name;
    EXPECT_EQ(static_cast<int>(topology.loops.size()), shape.loops) << shape.name;
    EXPECT_NEAR(areaOf(refined.mesh), areaOf(shape.data), 1e-12 * areaOf(shape.data)) << shape.name;
  }
}

TEST(SplitEdges, EveryCornerIsTheMeanOfTwoCornersOfItsOrigin) {
  const test::Shape shape = test::torus(7, 5);
  const RefinedMesh refined = splitEdges(shape.data, someEdges(shape.mesh(), 5));
  std::map<int, int> children;
  for (std::size_t f = 0; f < refined.mesh.triangles.size(); ++f) {
    const auto& from = shape.data.triangles[std::size_t(refined.faceOrigin[f])];
    ++children[refined.faceOrigin[f]];
    EXPECT_LE(refined.faceOrigin[f == 0 ? 0 : f - 1], refined.faceOrigin[f]);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = refined.mesh.positions[std::size_t(refined.mesh.triangles[f][k])];
      for (std::size_t i = 0; i < 3; ++i) {
        double mean = 0.0;
        for (int c : refined.cornerOrigin[f][k])
          mean += 0.5 * shape.data.positions[std::size_t(from[std::size_t(c)])][i];
        EXPECT_DOUBLE_EQ(p[i], mean);
      }
    }
  }
  std::map<int, int> kinds;
  for (const auto& [face, count] : children) ++kinds[count];
  for (int count : {1, 2, 3, 4}) EXPECT_GT(kinds[count], 0) << "no triangle divided in " << count;
}

TEST(SplitEdges, IgnoresPairsThatAreNoEdgeOfATriangle) {
  MeshData data = test::tetrahedron().data;
  data.positions.push_back({5, 5, 5});
  data.triangles.push_back({0, 0, 4});
  const RefinedMesh refined = splitEdges(data, {{1, 4}, {0, 4}, {2, 2}, {1, 0}, {0, 1}});
  ASSERT_EQ(refined.parents.size(), 1u);
  EXPECT_EQ(refined.parents[0], (VertexPair{0, 1}));
  EXPECT_EQ(refined.mesh.triangles.size(), data.triangles.size() + 2);
}

}  // namespace
}  // namespace hgp
