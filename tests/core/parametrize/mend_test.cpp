// Maps that a drag starts from, and reversed triangles of a frame.  Laws: seams that are apart are refused; where one vertex
// has left its place, mending brings all triangles back and moves nothing but what is near; a map without wrong
// triangles stays as it is; a ring that turns around the cone too seldom is wrong, reversed or not.
#include "hgp/parametrize/live/mend.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hgp/base/portable_math.h"
#include "solved_map.h"

namespace hgp::live {
namespace {

/// A certified map, and what mend() asks about it.
struct Mended : test_support::SolvedMap {
  Mended() : SolvedMap(test::jittered(test::icosphere(8), 0.01)) {}

  Mending mending() const {
    return {
        mesh,
        setup,
        *cut,
        setup.cones.front(),
        turnAngle(setup.field.spec.cones.front().k, setup.field.spec.q),
        [&](VertexId v) { return std::count(setup.cones.begin(), setup.cones.end(), v) == 0; },
        [&](VertexId v) { return setup.unknowns.vertexUnknown[v]; },
        [&](VertexId v) { return setup.field.u[v]; },
        [&](FaceId f) { return valueOf(faceTerms(setup.context->geometry, *cut, f).similar, x); }};
  }
  Complex corner(HalfedgeId h) const { return valueOf(cut->termsOf(h), x); }
  std::vector<FaceId> faces() const {
    std::vector<FaceId> all;
    for (FaceId f : mesh.faces()) all.push_back(f);
    return all;
  }
};

TEST(ReadMap, RefusesAMapWhoseSeamIsApartByMoreThanRounding) {
  const Mended on;
  double size = 0.0;
  for (const Vec2& p : on.map.uv)
    size = std::max(size, std::hypot(p[0] - on.map.uv[0][0], p[1] - on.map.uv[0][1]));
  int tried = 0;
  for (VertexId v : on.mesh.vertices()) {
    const int one = on.setup.cut.copy[on.mesh.outgoing(v)].i;
    const int other = on.setup.cut.copy[on.mesh.next(on.mesh.twin(on.mesh.outgoing(v)))].i;
    if (one == other || on.setup.unknowns.vertexUnknown[v] < 0) continue;
    ++tried;
    UvMap apart = on.map;
    apart.uv[at(one)][0] += 1e-8 * size;
    EXPECT_TRUE(readMap(on.mesh, on.setup, apart));
    apart.uv[at(one)][0] += 5e-6 * size;
    EXPECT_FALSE(readMap(on.mesh, on.setup, apart)) << "vertex " << v.i;
  }
  EXPECT_GT(tried, 5);
}

TEST(Mend, LeavesAMapWithoutReversedTrianglesAsItIs) {
  const Mended on;
  Eigen::VectorXcd x = on.x;
  EXPECT_TRUE(wrongFaces(on.mending(), x).empty());
  EXPECT_TRUE(mend(on.mending(), x));
  EXPECT_EQ(x, on.x);
}

TEST(Mend, TrianglesAroundTheConeAreWrongWhereTheirAnglesDoNotAddUp) {
  const Mended on;
  Mending other = on.mending();
  other.angle += turnAngle(1, on.setup.field.spec.q);
  const std::vector<FaceId> wrong = wrongFaces(other, on.x);
  std::size_t around = 0;
  for (HalfedgeId h : outgoingHalfedges(on.mesh, other.cone)) around += h.isValid();
  EXPECT_EQ(wrong.size(), around);
  for (FaceId f : wrong) {
    const auto corners = on.mesh.corners(f);
    EXPECT_TRUE(std::count(corners.begin(), corners.end(), other.cone));
  }
  EXPECT_EQ(wrongAmong(other, on.faces(), on.x), wrong);
}

TEST(Mend, BringsAVertexBackThatHasCrossedAnEdgeAndMovesOnlyWhatIsNear) {
  const Mended on;
  int tried = 0;
  for (int i = 0; i < on.mesh.vertexCount(); i += 26) {
    const VertexId v(i);
    const int unknown = on.setup.unknowns.vertexUnknown[v];
    const HalfedgeId h = on.mesh.outgoing(v);
    // The corner itself, not one that a seam turns.
    if (unknown < 0 || on.cut->termsOf(h).front().factor != Complex(1.0)) continue;
    ++tried;
    const Complex from = on.corner(h),
                  across = 0.5 * (on.corner(TriMesh::next(h)) + on.corner(TriMesh::previous(h)));
    Eigen::VectorXcd x = on.x;
    x[unknown] += 1.5 * (across - from);
    const std::vector<FaceId> wrong = wrongFaces(on.mending(), x);
    ASSERT_FALSE(wrong.empty());
    EXPECT_TRUE(std::count(wrong.begin(), wrong.end(), TriMesh::face(h)));
    EXPECT_EQ(wrongAmong(on.mending(), on.faces(), x), wrong);
    const Eigen::VectorXcd before = x;
    EXPECT_TRUE(mend(on.mending(), x)) << "vertex " << v.i;
    EXPECT_TRUE(wrongFaces(on.mending(), x).empty());
    int moved = 0;
    for (Eigen::Index n = 0; n < x.size(); ++n) moved += x[n] != before[n];
    EXPECT_LT(moved, 80) << "the vertices of five rings";
    EXPECT_LT(std::abs(x[unknown] - on.x[unknown]), std::abs(before[unknown] - on.x[unknown]));
  }
  EXPECT_GT(tried, 15);
}

}  // namespace
}  // namespace hgp::live
