#include "hgp/optimize/frame_fixing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/optimize/solved.h"

namespace hgp {
namespace {

/// Two cones whose angles are asked as (5, 1) · π/2, and frames of a connection that has them the
/// other way round: wrong by 2π at both, with the same seam rotations.
struct SwappedLifts {
  test::SeamlessProblem asked, wrong;
  VertexId v, w;

  const std::vector<Complex>& solveWrong() {
    z = wrong.solve(wrong.frames(), wrong.weightedOptions()).z;
    return z;
  }
  std::vector<Complex> z;
};

/// v and w with the given angles, and cones of 3π/2 spread out for what is left of Lemma 6.2.
HolonomySpec sphereSpec(const std::vector<VertexId>& places, int kv, int kw) {
  HolonomySpec spec;
  spec.cones = {{places[0], kv}, {places[1], kw}};
  for (int i = 2; i < 8; ++i) spec.cones.push_back({places[static_cast<std::size_t>(i)], 3});
  return spec;
}

std::vector<SwappedLifts> builtCases() {
  std::vector<SwappedLifts> cases;
  for (int n = 0; n < 5; ++n) {
    const TriMesh mesh =
        test::jittered(test::icosphere(5), 0.02, static_cast<unsigned>(n + 1)).mesh();
    std::vector<VertexId> places = test::spreadVertices(mesh, 8);
    std::rotate(places.begin(), places.begin() + n, places.end());
    auto asked = test::cutSurface("asked", mesh, sphereSpec(places, 5, 1));
    auto wrong = test::cutSurface("wrong", mesh, sphereSpec(places, 1, 5));
    cases.push_back({test::problemOf(std::move(*asked)),
                     test::problemOf(std::move(*wrong)),
                     places[0],
                     places[1],
                     {}});
  }
  return cases;
}

int measuredAt(const Certificate& certificate, VertexId v) {
  for (const MeasuredCone& cone : certificate.angles.cones)
    if (cone.vertex == v) return cone.measured;
  return certificate.q;
}

TEST(FrameFixing, AWrongLiftGivesAnInjectiveMapThatOnlyTheAngleCheckCatches) {
  for (SwappedLifts& built : builtCases()) {
    // Rotations cannot tell the two apart: they know angles up to 2π (§3.3).
    EXPECT_EQ(built.asked.surface.seams.rotation.raw(), built.wrong.surface.seams.rotation.raw());
    const Certificate certificate = built.asked.certify(built.solveWrong());
    EXPECT_FALSE(certificate.isCertified);
    EXPECT_EQ(certificate.orientation.constrainedPositive, certificate.orientation.constrained);
    EXPECT_TRUE(certificate.seams.broken.empty());
    EXPECT_EQ(measuredAt(certificate, built.v), 1);
    EXPECT_EQ(measuredAt(certificate, built.w), 5);
    bool isAngle = false;
    for (const Reason& reason : certificate.reasons) isAngle |= reason.rule == Rule::kConeAngle;
    EXPECT_TRUE(isAngle);
    if (certificate.orientation.negative == 0) {
      EXPECT_TRUE(built.wrong.certify(built.z).isCertified)
          << "a fine map of the other prescription";
    }
  }
}

TEST(FrameFixing, TheConnectionWithTheRightLiftRepairs) {
  for (SwappedLifts& built : builtCases()) {
    // Same system, same weights as before; only the frames are those of the recomputed connection.
    const Frames frames = built.asked.frames();
    const ProgramResult result = built.asked.solve(frames, built.asked.weightedOptions());
    EXPECT_TRUE(built.asked.certify(result.z).isCertified);
  }
}

TEST(FrameFixing, EmbeddedRingsHaveTheAskedAngles) {
  // §7.1: whatever else the program does, a map in the frames of the embedded ring has its angles.
  int repaired = 0, cases = 0;
  for (SwappedLifts& built : builtCases()) {
    const std::vector<Complex>& z = built.solveWrong();
    const test::CutSurface& s = built.asked.surface;
    Frames frames = built.wrong.frames();
    for (const auto& [cone, k] : {std::pair{built.v, 5}, {built.w, 1}})
      embedConeRing(s.mesh, s.context.geometry, s.cut, s.seams, z, cone, k, frames);
    const ProgramResult result = built.asked.solve(frames, built.asked.plainOptions());
    ++cases;
    if (result.status == socp::SolveStatus::kInfeasible) continue;
    const Certificate certificate = built.asked.certify(result.z);
    EXPECT_EQ(measuredAt(certificate, built.v), 5);
    EXPECT_EQ(measuredAt(certificate, built.w), 1);
    repaired += measuredAt(certificate, built.v) == 5 && measuredAt(certificate, built.w) == 1;
  }
  EXPECT_GE(repaired, cases - 1);
}

/// Around a ring, each frame against the next across the spoke between them: what the frames turn
/// by around the cone, in units of 2π/q, is k (Aigerman et al.'s continuity of the angle sum).
double turnOfFrames(const test::CutSurface& s, const Frames& frames, VertexId cone) {
  const auto angleOf = [&](HalfedgeId h) {
    const auto at = std::lower_bound(frames.faces.begin(), frames.faces.end(), TriMesh::face(h));
    return frames.angles[static_cast<std::size_t>(at - frames.faces.begin())];
  };
  double turned = 0.0;
  for (HalfedgeId h : outgoingHalfedges(s.mesh, cone)) {
    const HalfedgeId right = s.mesh.twin(h);
    const double step = angleOf(h) + turnAngle(s.seams.rotation[right], s.seams.q) -
                        angleOf(right) - transport(s.mesh, s.context.geometry, right);
    turned += std::remainder(step, 2 * kPi);
  }
  const double K = 2 * kPi - s.context.geometry.angleSum[cone];
  return s.seams.q * (1.0 - (K + turned) / (2 * kPi));
}

TEST(FrameFixing, AnEmbeddingTurnsTheFramesByK) {
  for (SwappedLifts& built : builtCases()) {
    const test::CutSurface& s = built.asked.surface;
    const Frames wrong = built.wrong.frames();
    EXPECT_NEAR(turnOfFrames(s, wrong, built.v), 1.0, 1e-6);
    EXPECT_NEAR(turnOfFrames(s, wrong, built.w), 5.0, 1e-6);
    Frames fromMap = wrong;
    embedConeRing(s.mesh, s.context.geometry, s.cut, s.seams, built.solveWrong(), built.v, 5,
                  fromMap);
    EXPECT_NEAR(turnOfFrames(s, fromMap, built.v), 5.0, 1e-6);
    // Only the ring's own frames have changed.
    for (std::size_t j = 0; j < wrong.faces.size(); ++j) {
      bool isRing = false;
      for (VertexId u : s.mesh.corners(wrong.faces[j])) isRing |= u == built.v;
      if (isRing) continue;
      EXPECT_EQ(fromMap.angles[j], wrong.angles[j]);
    }
  }
}

TEST(FrameFixing, AnEmbeddedRingIsFeasibleByItself) {
  // The local embedding is itself a map of the ring in all its frames.
  SwappedLifts built = std::move(builtCases()[0]);
  const test::CutSurface& s = built.asked.surface;
  for (const auto& [cone, k] : {std::pair{built.v, 5}, {built.w, 1}}) {
    Frames frames = built.asked.frames();
    embedConeRing(s.mesh, s.context.geometry, s.cut, s.seams, built.solveWrong(), cone, k, frames);
    Frames ring;
    for (std::size_t j = 0; j < frames.faces.size(); ++j)
      for (VertexId u : s.mesh.corners(frames.faces[j]))
        if (u == cone) {
          ring.faces.push_back(frames.faces[j]);
          ring.angles.push_back(frames.angles[j]);
        }
    const ProgramResult result = built.asked.solve(ring, built.asked.plainOptions());
    EXPECT_NE(result.status, socp::SolveStatus::kInfeasible);
    EXPECT_EQ(measuredAt(built.asked.certify(result.z), cone), k);
  }
}

}  // namespace
}  // namespace hgp
