#include "hgp/mesh/nearby_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "hgp/mesh/topology.h"
#include "support/shapes.h"

namespace hgp {
namespace {

std::vector<HalfedgeId> inOldNumbers(const std::vector<HalfedgeId>& path, const Numbering& n) {
  std::vector<HalfedgeId> old;
  for (HalfedgeId h : path)
    old.push_back(HalfedgeId(3 * n.faces[static_cast<std::size_t>(h.i / 3)] + h.i % 3));
  return old;
}

bool isPermutation(std::vector<int> ids, int count) {
  std::sort(ids.begin(), ids.end());
  for (int i = 0; i < static_cast<int>(ids.size()); ++i)
    if (ids[static_cast<std::size_t>(i)] != i) return false;
  return static_cast<int>(ids.size()) == count;
}

TEST(NearbyOrder, IsTheSameSurfaceWithTheSameLoopsAndGenerators) {
  std::vector<test::Shape> shapes = test::all();
  shapes.push_back(test::withoutFaces(test::pretzel(3, 3), {0, 100, 200}));
  for (const test::Shape& ordered : shapes) {
    const test::Shape shape = test::scattered(ordered);
    const TriMesh mesh = shape.mesh();
    const Numbering numbering = nearbyNumbering(mesh);
    ASSERT_TRUE(isPermutation(numbering.vertices, mesh.vertexCount())) << shape.name;
    ASSERT_TRUE(isPermutation(numbering.faces, mesh.faceCount())) << shape.name;
    const TriMesh other = renumbered(mesh, numbering);
    for (FaceId f : other.faces()) {
      const auto old = mesh.corners(FaceId(numbering.faces[static_cast<std::size_t>(f.i)]));
      for (std::size_t k = 0; k < 3; ++k) {
        const VertexId v = other.corners(f)[k];
        EXPECT_EQ(numbering.vertices[static_cast<std::size_t>(v.i)], old[k].i);
        EXPECT_EQ(other.position(v), mesh.position(old[k]));
      }
    }
    const Topology topology = computeTopology(mesh), same = computeTopology(other);
    ASSERT_EQ(topology.loops.size(), same.loops.size()) << shape.name;
    for (std::size_t j = 0; j < same.loops.size(); ++j)
      EXPECT_EQ(inOldNumbers(same.loops[j].halfedges, numbering), topology.loops[j].halfedges);
    const auto generators = handleGenerators(mesh), again = handleGenerators(other);
    ASSERT_EQ(generators.size(), again.size()) << shape.name;
    for (std::size_t i = 0; i < again.size(); ++i)
      EXPECT_EQ(inOldNumbers(again[i].crossed, numbering), generators[i].crossed) << shape.name;
  }
}

TEST(NearbyOrder, CanBeGivenToASurfaceThatHasBeenRenumberedAlready) {
  const TriMesh mesh = test::scattered(test::pretzel(2, 2)).mesh();
  const Numbering first = nearbyNumbering(mesh);
  const TriMesh once = renumbered(mesh, first);
  const Numbering second = nearbyNumbering(once);
  const TriMesh twice = renumbered(once, second);
  const auto generators = handleGenerators(mesh), again = handleGenerators(twice);
  ASSERT_EQ(generators.size(), again.size());
  for (std::size_t i = 0; i < again.size(); ++i) {
    std::vector<HalfedgeId> path;
    for (HalfedgeId h : inOldNumbers(again[i].crossed, second)) path.push_back(h);
    EXPECT_EQ(inOldNumbers(path, first), generators[i].crossed);
  }
}

TEST(NearbyOrder, NumbersComponentsAndIsolatedVerticesOnce) {
  MeshData data = test::icosphere(3).data;
  const int count = static_cast<int>(data.positions.size());
  data.positions.push_back({9, 9, 9});
  for (const Vec3& p : test::cube(2).data.positions)
    data.positions.push_back({p[0] + 5, p[1], p[2]});
  for (auto t : test::cube(2).data.triangles)
    data.triangles.push_back({t[0] + count + 1, t[1] + count + 1, t[2] + count + 1});
  const TriMesh mesh = buildUsableMesh(data);
  const Numbering numbering = nearbyNumbering(mesh);
  EXPECT_TRUE(isPermutation(numbering.vertices, mesh.vertexCount()));
  EXPECT_TRUE(isPermutation(numbering.faces, mesh.faceCount()));
  EXPECT_EQ(numbering.vertices.back(), count);
  EXPECT_EQ(computeTopology(renumbered(mesh, numbering)).isolatedVertexCount, 1);
}

/// Mean distance of the numbers of faces across an edge, relative to their count.
double apart(const TriMesh& mesh) {
  double sum = 0.0;
  for (HalfedgeId h : mesh.halfedges())
    if (!mesh.isBoundary(h)) sum += std::abs(TriMesh::face(h).i - TriMesh::face(mesh.twin(h)).i);
  return sum / mesh.halfedgeCount() / mesh.faceCount();
}

TEST(NearbyOrder, BringsNeighboursTogetherWhereALargeFileScattersThem) {
  const test::Shape sphere = test::icosphere(32);
  EXPECT_FALSE(isScattered(sphere.mesh()));
  const TriMesh mesh = test::scattered(sphere).mesh();
  EXPECT_TRUE(isScattered(mesh));
  EXPECT_GT(apart(mesh), 0.2);
  const TriMesh near = renumbered(mesh, nearbyNumbering(mesh));
  EXPECT_FALSE(isScattered(near));
  EXPECT_LT(apart(near), 0.02);
  EXPECT_FALSE(isScattered(test::scattered(test::icosphere(8)).mesh())) << "fits into any cache";
}

}  // namespace
}  // namespace hgp
