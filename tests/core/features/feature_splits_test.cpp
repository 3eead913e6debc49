// Edges that are split where features leave a map no room.
#include "hgp/features/feature_splits.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/creases.h"
#include "support/shapes.h"

namespace hgp {
namespace {

bool has(const std::vector<EdgeId>& edges, EdgeId e) {
  return std::find(edges.begin(), edges.end(), e) != edges.end();
}

int countIn(const TriMesh& mesh, FaceId f, const std::vector<EdgeId>& edges) {
  int count = 0;
  for (int k = 0; k < 3; ++k) count += has(edges, mesh.edge(TriMesh::halfedge(f, k)));
  return count;
}

TEST(FeatureSplits, EveryTriangleBetweenFeaturesHasOneAndNoOtherEdgeIsSplit) {
  for (const test::Shape& shape : {test::tetrahedron(), test::octahedron(), test::cube(1)}) {
    const TriMesh mesh = shape.mesh();
    const std::vector<EdgeId> creases = test::creasesOf(mesh);
    const std::vector<EdgeId> split = edgesOfCrowded(mesh, creases);
    std::vector<EdgeId> useful;
    for (FaceId f : mesh.faces()) {
      if (countIn(mesh, f, creases) < 3) continue;
      EXPECT_GE(countIn(mesh, f, split), 1) << shape.name;
      for (int k = 0; k < 3; ++k) useful.push_back(mesh.edge(TriMesh::halfedge(f, k)));
    }
    for (EdgeId e : split) EXPECT_TRUE(has(useful, e)) << shape.name;
    EXPECT_EQ(split.empty(), useful.empty()) << shape.name;
    // Half of the triangles at most need an edge of their own: two share one where that is possible.
    EXPECT_LE(2 * static_cast<int>(split.size()), mesh.faceCount()) << shape.name;
  }
}

TEST(FeatureSplits, ChordsAreNoFeaturesAndJoinVerticesOnFeatures) {
  const TriMesh coarse = test::cube(1).mesh();  // a diagonal in each of six squares
  EXPECT_EQ(chords(coarse, test::creasesOf(coarse)).size(), 6u);
  const TriMesh fine = test::cube(4).mesh();
  const std::vector<EdgeId> creases = test::creasesOf(fine);
  PerVertex<char> isOn(at(fine.vertexCount()), 0);
  for (EdgeId e : creases)
    isOn[fine.tail(fine.halfedge(e))] = isOn[fine.head(fine.halfedge(e))] = 1;
  const std::vector<EdgeId> found = chords(fine, creases);
  for (EdgeId e : fine.edges()) {
    const HalfedgeId h = fine.halfedge(e);
    const bool isChord = isOn[fine.tail(h)] && isOn[fine.head(h)] && !has(creases, e);
    EXPECT_EQ(has(found, e), isChord);
  }
  EXPECT_FALSE(found.empty());  // the triangles in corners
  EXPECT_TRUE(chords(fine, {}).empty());
}

TEST(FeatureSplits, EdgesAroundFeaturesAreThoseOfTheTrianglesThere) {
  const TriMesh mesh = test::cube(6).mesh();
  const std::vector<EdgeId> creases = test::creasesOf(mesh);
  const std::vector<EdgeId> around = edgesAround(mesh, creases);
  for (EdgeId e : creases) EXPECT_TRUE(has(around, e));
  for (EdgeId e : chords(mesh, creases)) EXPECT_TRUE(has(around, e));
  EXPECT_LT(around.size(), at(mesh.edgeCount()));
  EXPECT_TRUE(edgesAround(mesh, {}).empty());
}

}  // namespace
}  // namespace hgp
