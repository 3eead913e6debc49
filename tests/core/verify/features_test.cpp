// Straight features as the verifier sees them.  Laws: equality of bits decides; chains end at branches and corners.
#include "hgp/verify/features.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hgp/verify/angles.h"
#include "hgp/verify/certificate.h"
#include "support/creases.h"

namespace hgp {
namespace {

/// The flat shapes of test::shapes mapped by themselves.
struct FlatMap {
  TriMesh mesh;
  UvMap map;
  std::vector<EdgeId> features;

  explicit FlatMap(const test::Shape& shape) : mesh(shape.mesh()) {
    for (const Vec3& p : shape.data.positions) map.uv.push_back({p[0], p[1]});
    map.cornerUv = shape.data.triangles;
    features = test::creasesOf(mesh);
  }
  CornerUv corners() const {
    CornerUv uv(at(mesh.halfedgeCount()));
    for (HalfedgeId h : mesh.halfedges())
      uv[h] = map.uv[at(map.cornerUv[at(h.i / 3)][at(h.i % 3)])];
    return uv;
  }
  FeatureFacts measure() const {
    const CornerUv uv = corners();
    return measureFeatures(mesh, features, uv, computeUvAngles(mesh, uv));
  }
  Certificate certificate() const {
    HolonomySpec spec;
    spec.features = features;
    return certify(mesh, spec, map);
  }
};

TEST(Features, OfARectangleAreFourChainsWithFourCorners) {
  const FlatMap flat(test::grid(5, 3));
  const FeatureFacts facts = flat.measure();
  EXPECT_EQ(facts.edges, 16);
  EXPECT_EQ(facts.straightEdges, 16);
  EXPECT_EQ(facts.chains, 4);
  EXPECT_EQ(facts.straightChains, 4);
  EXPECT_EQ(facts.corners, 4);
  EXPECT_TRUE(flat.certificate().isCertified);
}

TEST(Features, CornersAreWhereTheyAreAskedFor) {
  const FlatMap flat(test::grid(5, 3));
  const auto reasons = [&](std::vector<ConePoint> corners, int q = 4) {
    HolonomySpec spec;
    spec.q = q;
    spec.features = flat.features;
    spec.corners = std::move(corners);
    return certify(flat.mesh, spec, flat.map).reasons;
  };
  const auto point = [](int v, int k) { return ConePoint{VertexId(v), k}; };
  const std::vector<ConePoint> there = {point(0, 1), point(5, 1), point(18, 1), point(23, 1)};
  EXPECT_TRUE(reasons(there).empty());
  // With an odd q nothing is straight: π is no multiple of 2π/q.
  const std::vector<Reason> odd = reasons(there, 3);
  EXPECT_TRUE(std::any_of(odd.begin(), odd.end(), [](const Reason& r) {
    return r.rule == Rule::kPrescription && r.count == 4;
  }));
  const auto expectWrong = [&](std::vector<ConePoint> corners, Rule rule, int count) {
    const std::vector<Reason> found = reasons(std::move(corners));
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].rule, rule);
    EXPECT_EQ(found[0].count, count);
  };
  // Its other vertices are straight, so that both ends of a move are wrong.
  expectWrong({point(1, 1), point(5, 1), point(18, 1), point(23, 1)}, Rule::kConeAngle, 2);
  expectWrong({point(0, 1), point(5, 1), point(18, 1)}, Rule::kConeAngle, 1);
  expectWrong({point(0, 3), point(5, 1), point(18, 1), point(23, 1)}, Rule::kConeAngle, 1);
  expectWrong({point(0, 1), point(0, 1), point(5, 1), point(18, 1), point(23, 1)},
              Rule::kPrescription, 1);
  expectWrong({point(7, 4), point(0, 1), point(5, 1), point(18, 1), point(23, 1)},
              Rule::kPrescription, 1);
}

TEST(Features, AreNotStraightIfOneBitDiffers) {
  FlatMap flat(test::grid(5, 3));
  // Vertex 2 lies on the lower side, v = 0 there.
  flat.map.uv[2][1] = 1e-300;
  const FeatureFacts facts = flat.measure();
  EXPECT_EQ(facts.straightEdges, 14);
  EXPECT_EQ(facts.straightChains, 3);
  EXPECT_EQ(facts.chains, 4);
  const Certificate certificate = flat.certificate();
  EXPECT_FALSE(certificate.isCertified);
  ASSERT_EQ(certificate.reasons.size(), 1u);
  EXPECT_EQ(certificate.reasons[0].rule, Rule::kFeature);
  EXPECT_EQ(certificate.reasons[0].count, 2);
}

TEST(Features, WithoutLengthAreNotStraight) {
  FlatMap flat(test::grid(5, 3));
  flat.map.uv[2] = flat.map.uv[1];
  EXPECT_LT(flat.measure().straightEdges, 16);
}

TEST(Features, OfARoundRimAreNotStraight) {
  const FlatMap flat(test::disk(5));
  EXPECT_FALSE(flat.certificate().isCertified);
  EXPECT_GT(flat.certificate().features.notStraight.size(), 20u);
}

TEST(Features, InsideEndAtBranchesAndDanglingEnds) {
  FlatMap flat(test::grid(4, 4));
  const auto edge = [&](int a, int b) {
    for (EdgeId e : flat.mesh.edges()) {
      const HalfedgeId h = flat.mesh.halfedge(e);
      if (std::minmax(flat.mesh.tail(h).i, flat.mesh.head(h).i) == std::minmax(a, b)) return e;
    }
    return EdgeId();
  };
  // Vertices are numbered row by row, five a row: a cross without its upper arm.
  flat.features = {edge(11, 12), edge(12, 13), edge(7, 12)};
  const FeatureFacts facts = flat.measure();
  EXPECT_EQ(facts.edges, 3);
  EXPECT_EQ(facts.straightEdges, 3);
  EXPECT_EQ(facts.chains, 3);
  EXPECT_EQ(facts.corners, 0);
}

TEST(Features, ThatAreNoEdgesOfTheMeshAreRefused) {
  FlatMap flat(test::grid(2, 2));
  flat.features = {EdgeId(1000)};
  const Certificate certificate = flat.certificate();
  EXPECT_FALSE(certificate.isCertified);
  ASSERT_FALSE(certificate.reasons.empty());
  EXPECT_EQ(certificate.reasons[0].rule, Rule::kPrescription);
}

}  // namespace
}  // namespace hgp
