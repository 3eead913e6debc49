#include "hgp/mesh/tri_mesh.h"

#include <gtest/gtest.h>

#include "support/shapes.h"

namespace hgp {
namespace {

class Shapes : public testing::TestWithParam<test::Shape> {};
std::string shapeName(const testing::TestParamInfo<test::Shape>& shape) {
  std::string name = shape.param.name + std::to_string(shape.index);
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return name;
}
INSTANTIATE_TEST_SUITE_P(All, Shapes, testing::ValuesIn(test::all()), shapeName);

TEST_P(Shapes, NextAndPreviousGoRoundTheFace) {
  const TriMesh mesh = GetParam().mesh();
  for (HalfedgeId h : mesh.halfedges()) {
    EXPECT_EQ(TriMesh::previous(TriMesh::next(h)), h);
    EXPECT_EQ(TriMesh::next(TriMesh::next(TriMesh::next(h))), h);
    EXPECT_EQ(TriMesh::face(TriMesh::next(h)), TriMesh::face(h));
    EXPECT_EQ(mesh.head(h), mesh.tail(TriMesh::next(h)));
  }
}

TEST_P(Shapes, KeepsTheFilesOwnNumbers) {
  const test::Shape& shape = GetParam();
  const TriMesh mesh = shape.mesh();
  ASSERT_EQ(mesh.faceCount(), static_cast<int>(shape.data.triangles.size()));
  for (FaceId f : mesh.faces())
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(mesh.corners(f)[k].i, shape.data.triangles[static_cast<std::size_t>(f.i)][k]);
  for (VertexId v : mesh.vertices())
    EXPECT_EQ(mesh.position(v), shape.data.positions[static_cast<std::size_t>(v.i)]);
}

TEST_P(Shapes, TwinsRunTheOtherWayAndShareTheEdge) {
  const TriMesh mesh = GetParam().mesh();
  for (HalfedgeId h : mesh.halfedges()) {
    const HalfedgeId twin = mesh.twin(h);
    EXPECT_EQ(mesh.isBoundary(h), !twin.isValid());
    if (!twin.isValid()) continue;
    EXPECT_EQ(mesh.twin(twin), h);
    EXPECT_NE(TriMesh::face(twin), TriMesh::face(h));
    EXPECT_EQ(mesh.tail(twin), mesh.head(h));
    EXPECT_EQ(mesh.head(twin), mesh.tail(h));
    EXPECT_EQ(mesh.edge(twin), mesh.edge(h));
  }
  for (EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e);
    EXPECT_EQ(mesh.edge(h), e);
    EXPECT_TRUE(!mesh.twin(h).isValid() || h < mesh.twin(h));
  }
}

TEST_P(Shapes, OutgoingHalfedgesVisitEveryFaceOfAVertexOnce) {
  const TriMesh mesh = GetParam().mesh();
  PerVertex<int> faces(static_cast<std::size_t>(mesh.vertexCount()), 0);
  for (HalfedgeId h : mesh.halfedges()) ++faces[mesh.tail(h)];
  for (VertexId v : mesh.vertices()) {
    std::vector<HalfedgeId> seen;
    for (HalfedgeId h : outgoingHalfedges(mesh, v)) {
      EXPECT_EQ(mesh.tail(h), v);
      if (!seen.empty()) {
        // Counterclockwise: the last side of one face is the first side of the next.
        EXPECT_EQ(mesh.twin(TriMesh::previous(seen.back())), h);
      }
      seen.push_back(h);
    }
    std::sort(seen.begin(), seen.end());
    EXPECT_TRUE(std::unique(seen.begin(), seen.end()) == seen.end());
    EXPECT_EQ(static_cast<int>(seen.size()), faces[v]);
    EXPECT_EQ(mesh.valence(v), faces[v]);
  }
}

TEST_P(Shapes, BoundaryVerticesStartAtTheBoundary) {
  const TriMesh mesh = GetParam().mesh();
  PerVertex<char> isBoundary(static_cast<std::size_t>(mesh.vertexCount()), 0);
  for (HalfedgeId h : mesh.halfedges())
    if (mesh.isBoundary(h)) isBoundary[mesh.tail(h)] = isBoundary[mesh.head(h)] = 1;
  for (VertexId v : mesh.vertices()) {
    EXPECT_EQ(mesh.isBoundary(v), isBoundary[v] != 0);
    EXPECT_TRUE(!mesh.isBoundary(v) || mesh.isBoundary(mesh.outgoing(v)));
  }
}

TEST(TriMesh, RefusesWithTheReason) {
  MeshData data = test::cube().data;
  std::swap(data.triangles[0][0], data.triangles[0][1]);
  const Result<TriMesh> mesh = buildTriMesh(data);
  ASSERT_FALSE(mesh);
  EXPECT_EQ(mesh.error().code, ErrorCode::kUnsupported);
  EXPECT_EQ(mesh.error().where.size(), 3u);
}

TEST(TriMesh, AnEmptyMeshHasNothing) {
  const Result<TriMesh> mesh = buildTriMesh({});
  ASSERT_TRUE(mesh);
  EXPECT_EQ(mesh->faceCount(), 0);
  EXPECT_EQ(mesh->edgeCount(), 0);
}

}  // namespace
}  // namespace hgp
