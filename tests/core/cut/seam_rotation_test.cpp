#include "hgp/cut/seam_rotation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/seamless.h"

namespace hgp {
namespace {

TEST(SeamRotations, AreOppositeOnTheTwoSidesAndZeroOffTheSeam) {
  for (const test::CutSurface& s : test::cutSurfaces()) {
    for (HalfedgeId h : s.mesh.halfedges()) {
      const int r = s.seams.rotation[h];
      EXPECT_GE(r, 0);
      EXPECT_LT(r, s.seams.q);
      if (s.mesh.isBoundary(h) || !s.cut.isSeam[s.mesh.edge(h)]) {
        EXPECT_EQ(r, 0) << s.name;
      } else
        EXPECT_EQ(reduceTurn(r + s.seams.rotation[s.mesh.twin(h)], s.seams.q), 0) << s.name;
    }
  }
}

TEST(SeamRotations, AroundAVertexAddUpToMinusKAndAroundALoopToL) {
  for (const test::CutSurface& s : test::cutSurfaces()) {
    const auto counterclockwise = [&](VertexId v) {
      long long sum = 0;
      for (HalfedgeId h : outgoingHalfedges(s.mesh, v))
        if (!s.mesh.isBoundary(h)) sum += s.seams.rotation[s.mesh.twin(h)];
      return sum;
    };
    for (VertexId v : s.mesh.vertices())
      if (!s.mesh.isBoundary(v)) {
        EXPECT_EQ(reduceTurn(counterclockwise(v), s.seams.q), reduceTurn(-s.k(v), s.seams.q))
            << s.name << " vertex " << v.i;
      }
    for (std::size_t j = 0; j < s.context.topology.loops.size(); ++j) {
      long long sum = 0;
      for (HalfedgeId h : s.context.topology.loops[j].halfedges)
        sum += counterclockwise(s.mesh.tail(h));
      EXPECT_EQ(reduceTurn(sum, s.seams.q), reduceTurn(s.field.spec.turning[j], s.seams.q))
          << s.name;
    }
  }
}

TEST(SeamRotations, AlongEveryGeneratorAddUpToThePrescribedHolonomy) {
  for (const test::CutSurface& s : test::cutSurfaces()) {
    for (std::size_t i = 0; i < s.context.handles.loops.size(); ++i) {
      long long sum = 0;
      for (HalfedgeId h : s.context.handles.loops[i].crossed) sum += s.seams.rotation[h];
      EXPECT_EQ(reduceTurn(sum, s.seams.q), s.field.spec.handles[i]) << s.name;
    }
  }
}

TEST(SeamRotations, AreConstantAlongAChain) {
  for (const test::CutSurface& s : test::cutSurfaces())
    for (const SeamChain& chain : s.cut.chains)
      for (HalfedgeId h : chain.left)
        EXPECT_EQ(s.seams.rotation[h], s.seams.rotation[chain.left[0]]) << s.name;
}

TEST(SeamRotations, FramesAreTheFieldAndContinueAcrossTheSeamTurnedByR) {
  for (const test::CutSurface& s : test::cutSurfaces()) {
    const int q = s.seams.q;
    for (FaceId f : s.mesh.faces()) {  // one of the q directions of the field
      const double steps = (s.seams.frameAngle[f] - s.field.field.angle[f]) * q / (2 * kPi);
      EXPECT_NEAR(steps, std::round(steps), 1e-9) << s.name;
    }
    for (EdgeId e : s.mesh.edges()) {
      const HalfedgeId h = s.mesh.halfedge(e);
      if (s.mesh.isBoundary(h)) continue;
      const FaceId f = TriMesh::face(h), g = TriMesh::face(s.mesh.twin(h));
      // The map turns both frames onto the real axis, so uv vectors of the shared edge differ by
      // what the directions differ by: the field's own matching, combed.
      const double own =
          s.field.field.angle[g] + turnAngle(s.field.field.matching[h], q) - s.field.field.angle[f];
      const double combed =
          s.seams.frameAngle[g] + turnAngle(s.seams.rotation[h], q) - s.seams.frameAngle[f];
      EXPECT_NEAR(std::remainder(combed - own, 2 * kPi), 0.0, 1e-9) << s.name;
    }
  }
}

}  // namespace
}  // namespace hgp
