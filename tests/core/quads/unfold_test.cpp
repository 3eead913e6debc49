// Quads that fold in space.  Laws: walks are straight in the unfolded plane and lead back; unfolding leaves fewer folded
// quads, moves vertices along the surface only, and no cone.
#include "hgp/quads/unfold.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "hgp/grid/snap.h"
#include "hgp/mesh/vectors.h"
#include "hgp/parametrize/parametrize.h"
#include "hgp/quads/quad_shapes.h"
#include "hgp/quads/surface_walk.h"
#include "support/shapes.h"

namespace hgp {
namespace {

SurfacePoint middleOf(const TriMesh& mesh, FaceId f) {
  SurfacePoint out{f, {}, {}};
  for (const VertexId v : mesh.corners(f))
    out.position = add(out.position, scaled(mesh.position(v), 1.0 / 3.0));
  return out;
}

TEST(WalkStraight, IsAStraightLineInAPlaneAndEndsAtItsBoundary) {
  const TriMesh mesh = test::grid(8, 6).mesh();
  const SurfacePoint start = middleOf(mesh, FaceId(40));
  const double edge = distance(mesh.position(mesh.tail(TriMesh::halfedge(FaceId(0), 0))),
                               mesh.position(mesh.head(TriMesh::halfedge(FaceId(0), 0))));
  for (const auto& direction : {std::array{1.0, 0.0}, {0.6, 0.8}, {-0.8, 0.6}, {0.28, -0.96}}) {
    const auto end = walkStraight(mesh, start, direction, 1.3 * edge);
    ASSERT_TRUE(end);
    EXPECT_NEAR(distance(end->position, start.position), 1.3 * edge, 1e-12 * edge);
    const auto half = walkStraight(mesh, start, direction, 0.65 * edge);
    ASSERT_TRUE(half);
    const Vec3 middle = scaled(add(start.position, end->position), 0.5);
    EXPECT_NEAR(distance(half->position, middle), 0.0, 1e-12 * edge);
    EXPECT_FALSE(walkStraight(mesh, start, direction, 1000.0 * edge));
  }
}

TEST(WalkStraight, GoesOverTheEdgesOfACube) {
  // From the middle of a side of length 1: along a normal of an edge over four sides and back to the start.
  const TriMesh mesh = test::cube(5).mesh();
  double length = 0.0;
  for (const VertexId v : mesh.vertices())
    length = std::max(length, distance(mesh.position(v), mesh.position(VertexId(0))));
  const double side = length / std::sqrt(3.0);
  int closed = 0;
  for (const FaceId f : {FaceId(0), FaceId(17), FaceId(60), FaceId(111)}) {
    const SurfacePoint start = middleOf(mesh, f);
    const auto end = walkStraight(mesh, start, {1.0, 0.0}, 4.0 * side);
    ASSERT_TRUE(end);
    closed += distance(end->position, start.position) < 1e-9 * side;
    const auto quarter = walkStraight(mesh, start, {1.0, 0.0}, side);
    ASSERT_TRUE(quarter);
    EXPECT_GT(distance(quarter->position, start.position), 0.5 * side);
  }
  EXPECT_GE(closed, 1);
}

/// The quads of a plate that is thinner than a cell.
struct Plate {
  test::Shape shape = test::jittered(test::icosphere(12), 0.002);
  TriMesh mesh;
  UvMap map;
  QuadMesh quads;

  Plate() : mesh(thin()) {
    const Result<CompleteSpec> spec = suggestCones(mesh, {});
    ParametrizeOptions options;
    options.grid = {500.0, 0.0, GridMode::kQuad};
    const Result<Parametrization> run = parametrize(mesh, toSpec(*spec), options);
    std::vector<VertexId> cones;
    for (const ConePoint& cone : spec->cones) cones.push_back(cone.vertex);
    map = *snapAligned(mesh, run->map, 4, cones);
    quads = *extractQuads(mesh, map, 4);
  }
  TriMesh thin() {
    for (Vec3& p : shape.data.positions) p = {p[0], 0.7 * p[1] + 0.2 * p[0] * p[0], 0.03 * p[2]};
    return shape.mesh();
  }
};

/// The distance of a point from a face.
double distanceFrom(const TriMesh& mesh, FaceId f, const Vec3& p) {
  const auto [a, b, c] = mesh.corners(f);
  const Vec3 n = cross(subtract(mesh.position(b), mesh.position(a)),
                       subtract(mesh.position(c), mesh.position(a)));
  return std::fabs(dot(subtract(p, mesh.position(a)), n)) / norm(n);
}

TEST(UnfoldInSpace, LeavesFewerFoldedQuadsMovesAlongTheSurfaceAndKeepsConesAndTheRest) {
  Plate plate;
  const QuadMesh before = plate.quads;
  const int folded = countFoldedInSpace(before);
  ASSERT_GE(folded, 3);
  const int fewer = unfoldInSpace(plate.mesh, plate.quads);
  EXPECT_EQ(countFoldedInSpace(plate.quads), folded - fewer);
  EXPECT_LE(countFoldedInSpace(plate.quads), folded / 2);
  EXPECT_EQ(plate.quads.quads, before.quads);
  int moved = 0;
  for (std::size_t v = 0; v < before.positions.size(); ++v) {
    EXPECT_LT(distanceFrom(plate.mesh, plate.quads.face[v], plate.quads.positions[v]), 1e-9);
    if (plate.quads.positions[v] == before.positions[v]) continue;
    ++moved;
    EXPECT_LT(before.coneVertex[v], 0);
  }
  EXPECT_GT(moved, 0);
  EXPECT_LT(moved, static_cast<int>(before.positions.size()) / 4);
}

TEST(UnfoldInSpace, WhatIsOnFeaturesStays) {
  Plate plate;
  const QuadMesh before = plate.quads;
  unfoldInSpace(plate.mesh, plate.quads);
  std::vector<char> isMoved;
  for (std::size_t v = 0; v < before.positions.size(); ++v)
    isMoved.push_back(plate.quads.positions[v] == before.positions[v] ? 0 : 1);
  QuadMesh held = before;
  held.isOnFeature = isMoved;
  unfoldInSpace(plate.mesh, held);
  for (std::size_t v = 0; v < before.positions.size(); ++v)
    EXPECT_TRUE(isMoved[v] == 0 || held.positions[v] == before.positions[v]) << v;
}

double distanceFromEdge(const TriMesh& mesh, EdgeId e, const Vec3& p) {
  const Vec3 &a = mesh.position(mesh.tail(mesh.halfedge(e))),
             &b = mesh.position(mesh.head(mesh.halfedge(e)));
  const Vec3 along = subtract(b, a);
  const double t = std::clamp(dot(subtract(p, a), along) / dot(along, along), 0.0, 1.0);
  return distance(p, add(a, scaled(along, t)));
}

TEST(QuadMesh, MarksJustTheVerticesOnTheGivenEdges) {
  const Plate plate;
  std::vector<EdgeId> features;
  for (EdgeId e : plate.mesh.edges())
    if (e.i % 7 == 3) features.push_back(e);
  for (const int halvings : {0, 1}) {
    const QuadMesh quads = *extractQuads(plate.mesh, plate.map, 4, halvings, features);
    ASSERT_EQ(quads.isOnFeature.size(), quads.positions.size());
    std::size_t marked = 0;
    for (std::size_t v = 0; v < quads.positions.size(); ++v) {
      const bool isOn = std::any_of(features.begin(), features.end(), [&](EdgeId e) {
        return distanceFromEdge(plate.mesh, e, quads.positions[v]) < 1e-12;
      });
      EXPECT_EQ(quads.isOnFeature[v] != 0, isOn) << v;
      marked += isOn ? 1 : 0;
    }
    EXPECT_GT(marked, 0u);
    EXPECT_LT(marked, quads.positions.size() / 2);
  }
}

}  // namespace
}  // namespace hgp
