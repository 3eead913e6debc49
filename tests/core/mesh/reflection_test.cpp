#include "hgp/mesh/reflection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hgp/mesh/topology.h"
#include "hgp/mesh/vectors.h"
#include "support/shapes.h"

namespace hgp {
namespace {

/// One side of a grid with a relief, glued to its mirror image; triangles in random order.
test::Shape glued(int n) {
  test::Shape shape = test::jittered(test::grid(n, n), 0.2);
  for (Vec3& p : shape.data.positions) {
    const bool isInPlane = std::fabs(p[0]) < 0.5;
    p[0] = isInPlane ? 0.0 : p[0];
  }
  std::vector<int> image;
  const std::size_t count = shape.data.positions.size();
  for (std::size_t v = 0; v < count; ++v) {
    const Vec3 p = shape.data.positions[v];
    image.push_back(static_cast<int>(p[0] == 0.0 ? v : shape.data.positions.size()));
    if (p[0] != 0.0) shape.data.positions.push_back({-p[0], p[1], p[2]});
  }
  const auto triangles = shape.data.triangles;
  for (const auto& [a, b, c] : triangles)
    shape.data.triangles.push_back({image[at(a)], image[at(c)], image[at(b)]});
  shape.name = "glued grid";
  return test::scattered(shape);
}

MirrorPlane planeNamed(const MeshData& mesh, const std::string& name) {
  const std::vector<MirrorPlane> planes = likelyPlanes(mesh);
  return *std::find_if(planes.begin(), planes.end(),
                       [&](const MirrorPlane& p) { return p.name == name; });
}

std::optional<Reflection> reflectionOf(const test::Shape& shape, const std::string& plane) {
  const TriMesh mesh = shape.mesh();
  return findReflection(mesh, mesh, planeNamed(shape.data, plane), 1e-6);
}

TEST(Reflection, IsAnInvolutionThatTurnsEveryTriangleOver) {
  for (const test::Shape& shape : {test::octahedron(), test::icosphere(4), glued(6), glued(9)}) {
    const TriMesh mesh = shape.mesh();
    const std::optional<Reflection> own = reflectionOf(shape, "X");
    ASSERT_TRUE(own) << shape.name;
    for (HalfedgeId h : mesh.halfedges()) {
      const HalfedgeId g = own->halfedge[h];
      EXPECT_EQ(own->halfedge[g], h) << shape.name;
      EXPECT_EQ(mesh.tail(g), own->vertex[mesh.head(h)]);
      EXPECT_EQ(mesh.head(g), own->vertex[mesh.tail(h)]);
      EXPECT_EQ(own->halfedge[TriMesh::next(h)], TriMesh::previous(g));
      EXPECT_EQ(mesh.isBoundary(h), mesh.isBoundary(g));
    }
    for (VertexId v : mesh.vertices()) {
      EXPECT_EQ(own->vertex[own->vertex[v]], v);
      const Vec3 there = mesh.position(own->vertex[v]), p = mesh.position(v);
      EXPECT_NEAR(there[0], -p[0], 1e-6);
      EXPECT_NEAR(there[1], p[1], 1e-6);
    }
    EXPECT_LE(own->distance, 1e-6);
  }
}

TEST(Reflection, IsFoundOnlyWhereTheTrianglesMatch) {
  const test::Shape moved = test::jittered(test::octahedron(), 0.1);
  EXPECT_FALSE(reflectionOf(moved, "X"));
  test::Shape flipped = glued(6);
  const TriMesh whole = flipped.mesh();
  // Another diagonal on one side keeps all vertices where they are.
  for (EdgeId e : whole.edges()) {
    const HalfedgeId h = whole.halfedge(e), g = whole.twin(h);
    if (!g.isValid()) continue;
    const VertexId a = whole.tail(h), b = whole.head(h);
    const VertexId c = whole.head(TriMesh::next(h)), d = whole.head(TriMesh::next(g));
    if (whole.position(a)[0] <= 0.0 || whole.position(b)[0] <= 0.0 || whole.valence(a) < 5 ||
        whole.valence(b) < 5)
      continue;
    flipped.data.triangles[at(TriMesh::face(h).i)] = {c.i, d.i, b.i};
    flipped.data.triangles[at(TriMesh::face(g).i)] = {d.i, c.i, a.i};
    break;
  }
  const TriMesh mesh = flipped.mesh();
  const MirrorPlane plane = planeNamed(flipped.data, "X");
  EXPECT_FALSE(findReflection(mesh, mesh, plane, 1e-6));
  // The two triangles, and those whose images they were.
  const MirrorImages images = mirrorImages(mesh, plane, 1e-6);
  EXPECT_EQ(images.count, mesh.faceCount() - 4);
  EXPECT_TRUE(images.without.isValid());
  EXPECT_EQ(mirrorImages(whole, plane, 1e-6).count, whole.faceCount());
  EXPECT_FALSE(mirrorImages(whole, plane, 1e-6).without.isValid());
}

TEST(Reflection, ToleratesVerticesThatAreOffByLess) {
  const test::Shape shape = test::jittered(glued(6), 1e-4, 7);
  const TriMesh mesh = shape.mesh();
  const MirrorPlane plane = planeNamed(shape.data, "X");
  const std::optional<Reflection> own = findReflection(mesh, mesh, plane, 1e-3);
  ASSERT_TRUE(own);
  EXPECT_GT(own->distance, 0.0);
  EXPECT_FALSE(findReflection(mesh, mesh, plane, 0.1 * own->distance));
  EXPECT_EQ(mirrorImages(mesh, plane, 1e-3).count, mesh.faceCount());
  EXPECT_LT(mirrorImages(mesh, plane, 0.1 * own->distance).count, mesh.faceCount());
}

TEST(Reflection, PrincipalAxesFindThePlaneOfATurnedSurface) {
  test::Shape shape = glued(6);
  for (Vec3& p : shape.data.positions) p = {0.6 * p[0] - 0.8 * p[1], 0.8 * p[0] + 0.6 * p[1], 3.0};
  const TriMesh mesh = shape.mesh();
  int found = 0;
  for (const MirrorPlane& plane : likelyPlanes(shape.data)) {
    if (!plane.name.empty()) continue;
    EXPECT_NEAR(norm(plane.normal), 1.0, 1e-12);
    found += findReflection(mesh, mesh, plane, 1e-6).has_value();
  }
  EXPECT_EQ(found, 1);
}

/// A torus of 12 × 12 squares; place(t, p) of two angles, and isRising(i, j) of the diagonals.
template <class Place, class IsRising>
MeshData torusOf(const Place& place, const IsRising& isRising) {
  constexpr int kN = 12;
  MeshData out;
  const auto id = [](int i, int j) { return (i % kN) * kN + j % kN; };
  for (int i = 0; i < kN; ++i)
    for (int j = 0; j < kN; ++j) {
      out.positions.push_back(place(std::acos(-1.0) * i / 6, std::acos(-1.0) * j / 6));
      const int a = id(i, j), b = id(i + 1, j), c = id(i + 1, j + 1), d = id(i, j + 1);
      if (isRising(i, j))
        out.triangles.insert(out.triangles.end(), {{a, b, c}, {a, c, d}});
      else
        out.triangles.insert(out.triangles.end(), {{a, b, d}, {b, c, d}});
    }
  return out;
}

TEST(Reflection, HasTwoSidesOnlyIfItsPlaneCutsTheSurfaceApart) {
  for (const test::Shape& shape :
       {test::octahedron(), test::icosphere(1), test::icosphere(4), glued(6)}) {
    const std::optional<Reflection> own = reflectionOf(shape, "X");
    ASSERT_TRUE(own) << shape.name;
    EXPECT_TRUE(hasTwoSides(shape.mesh(), *own)) << shape.name;
  }
  // (t, p) → (t + π, −p) leaves no point in place.
  const MeshData free = torusOf(
      [](double t, double p) {
        return Vec3{std::cos(t) * (2 + 1.1 * std::cos(p)), std::cos(p) + 0.2 * std::cos(2 * t),
                    std::sin(p) * std::sin(t) + 0.3 * std::sin(2 * t)};
      },
      [](int i, int) { return i < 6; });
  // (t, p) → (p, t) leaves a circle in place, beside which the rest is in one piece.
  const auto exchanged = [](double t, double p) {
    return Vec3{std::sin(t) - std::sin(p) + 0.4 * (std::cos(t) - std::cos(p)),
                std::cos(t) + std::cos(p) + 0.3 * std::sin(t) * std::sin(p),
                std::sin(t) + std::sin(p) + 0.2 * std::cos(t) * std::cos(p)};
  };
  const MeshData along = torusOf(exchanged, [](int, int) { return true; });
  const MeshData across = torusOf(exchanged, [](int, int) { return false; });
  for (const MeshData& data : {free, along, across}) {
    const test::Shape shape{"torus", data, 1, 0};
    const std::optional<Reflection> own = reflectionOf(shape, "X");
    ASSERT_TRUE(own);
    EXPECT_FALSE(hasTwoSides(shape.mesh(), *own));
  }
}

TEST(MirrorImages, AreTurnedOver) {
  // A triangle, its image, and the image of another one that is not turned over.
  test::Shape shape;
  shape.data.positions = {{1, 0, 0},  {2, 0, 0},  {1, 1, 0},  {-1, 0, 0}, {-2, 0, 0},
                          {-1, 1, 0}, {1, 0, 5},  {2, 0, 5},  {1, 1, 5},  {-1, 0, 5},
                          {-2, 0, 5}, {-1, 1, 5}, {3, 0, 0.5}};
  shape.data.triangles = {{0, 1, 2}, {4, 3, 5}, {6, 7, 8}, {9, 10, 11}};
  const TriMesh mesh = shape.mesh();
  const MirrorImages images = mirrorImages(mesh, {"X", {1.0, 0.0, 0.0}, 0.0}, 1e-9);
  EXPECT_EQ(images.count, 2);
  EXPECT_EQ(images.without, FaceId(2));
}

TEST(Reflection, OfATinySurfaceIsTheNearestOne) {
  for (unsigned seed = 1; seed < 6; ++seed) {
    const test::Shape shape = test::scattered(test::icosphere(3), seed);
    const TriMesh mesh = shape.mesh();
    const auto own = findReflection(mesh, mesh, planeNamed(shape.data, "X"), 10.0);
    ASSERT_TRUE(own);
    EXPECT_LT(own->distance, 1e-9);
  }
}

TEST(LikelyPlanes, IgnoreUnusedVerticesAndOffsetsOfRoundingErrors) {
  test::Shape shape = test::icosphere(3);
  for (Vec3& p : shape.data.positions) p = {1.5 * p[0] + 5.0, p[1] + 3e-7, 0.7 * p[2]};
  const auto planes = likelyPlanes(shape.data);
  ASSERT_EQ(planes.size(), 3U);
  EXPECT_NEAR(planes[0].offset, 5.0, 1e-9);
  EXPECT_EQ(planes[1].offset, 0.0);
  EXPECT_EQ(planes[2].offset, 0.0);
  shape.data.positions.push_back({0.0, -9.0, 0.0});
  const auto others = likelyPlanes(shape.data);
  ASSERT_EQ(others.size(), planes.size());
  for (std::size_t n = 0; n < planes.size(); ++n) EXPECT_EQ(others[n].offset, planes[n].offset);
}

TEST(HalfSurface, HasHalfOfTheTrianglesAndItsNewRimInThePlane) {
  for (const test::Shape& shape : {test::octahedron(), test::icosphere(4), glued(6)}) {
    const TriMesh mesh = shape.mesh();
    const std::optional<Reflection> own = reflectionOf(shape, "X");
    ASSERT_TRUE(own);
    if (!edgesAcross(mesh, *own).empty()) continue;
    const HalfSurface half = halfOf(mesh, *own, planeNamed(shape.data, "X"));
    EXPECT_EQ(2 * half.mesh.faceCount(), mesh.faceCount());
    std::size_t inPlane = 0;
    for (HalfedgeId h : half.mesh.halfedges()) {
      EXPECT_EQ(half.vertexOrigin[at(half.mesh.tail(h).i)], mesh.tail(half.origin(h)));
      EXPECT_GE(half.mesh.position(half.mesh.tail(h))[0], -1e-6);
      if (half.mesh.isBoundary(h) && !mesh.isBoundary(half.origin(h))) ++inPlane;
    }
    EXPECT_EQ(inPlane, edgesInPlane(mesh, *own).size()) << shape.name;
    EXPECT_EQ(computeTopology(half.mesh).componentCount, 1);
  }
}

}  // namespace
}  // namespace hgp
