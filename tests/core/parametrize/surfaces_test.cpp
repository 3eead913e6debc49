#include <gtest/gtest.h>

#include <cmath>

#include "hgp/field/prepared_surface.h"
#include "hgp/parametrize/parametrize.h"
#include "hgp/parametrize/seamless_setup.h"
#include "support/prescriptions.h"
#include "support/shapes.h"

namespace hgp {
namespace {

/// What a caller may rely on for every certified result.
void expectCertified(const TriMesh& mesh, const Result<Parametrization>& p,
                     const std::string& name) {
  ASSERT_TRUE(p) << name << ": " << p.error().message;
  ASSERT_TRUE(p->isCertified) << name << ": "
                              << (p->certificate.reasons.empty()
                                      ? ""
                                      : p->certificate.reasons[0].message);
  EXPECT_EQ(p->certificate.orientation.positive, mesh.faceCount());
  EXPECT_LE(p->certificate.seams.largestRelativeResidual, 1e-8);
  ASSERT_EQ(p->copyOf.size(), p->map.uv.size());
  for (FaceId f : mesh.faces())
    for (std::size_t k = 0; k < 3; ++k) {
      const int copy = p->map.cornerUv[static_cast<std::size_t>(f.i)][k];
      EXPECT_EQ(p->copyOf[static_cast<std::size_t>(copy)], mesh.corners(f)[k]);
    }
  EXPECT_FALSE(p->rounds.empty());
  EXPECT_FALSE(p->times.empty());
  // And the verifier says so to anyone who asks again.
  EXPECT_TRUE(certify(mesh, p->spec, p->map).isCertified);
}

Result<Parametrization> withItsOwnCones(const TriMesh& mesh, Method method = Method::kAuto) {
  PreparedSurface surface(mesh);
  const Result<CompleteSpec> cones = suggestCones(surface, {});
  if (!cones) return cones.error();
  ParametrizeOptions options;
  options.method = method;
  return parametrize(surface, toSpec(*cones), options);
}

TEST(Parametrize, FlatTorusWithoutConesIsCertifiedAndConformalWhereItCanBe) {
  for (const test::Shape& shape : {test::torus(12, 8), test::jittered(test::torus(14, 9), 0.02)}) {
    const TriMesh mesh = shape.mesh();
    const bool isSymmetric = shape.name == test::torus(12, 8).name;
    for (int q : {1, 4, 6}) {
      HolonomySpec spec;
      spec.q = q;
      const Result<Parametrization> p = parametrize(mesh, spec, {});
      expectCertified(mesh, p, shape.name);
      EXPECT_EQ(p->spec.handles, (std::vector<int>{0, 0}));
      // With symmetric weights an exactly harmonic map exists; otherwise the weights' left kernel is
      // real, and an exact one would squeeze the torus into a line.
      EXPECT_LT(p->rounds.back().laplacianEnergy, isSymmetric ? 1e-20 : 1e-5);
    }
  }
}

TEST(Parametrize, ANearlyFlatTorusNeedsNoCones) {
  for (const test::Shape& shape :
       {test::torus(40, 20), test::jittered(test::torus(40, 20), 0.01)}) {
    const TriMesh mesh = shape.mesh();
    const Result<Parametrization> p = withItsOwnCones(mesh);
    expectCertified(mesh, p, shape.name);
    EXPECT_TRUE(p->spec.cones.empty()) << shape.name;
    EXPECT_LT(p->certificate.distortion.meanMu, 0.2) << shape.name;
  }
  // A pretzel has another topology, a bumpy torus another scale: both keep their cones.
  const Result<CompleteSpec> pretzel = suggestCones(test::pretzel(1, 3).mesh(), {});
  ASSERT_TRUE(pretzel);
  EXPECT_FALSE(pretzel->cones.empty());
}

TEST(Parametrize, AutomaticConesAreCertifiedOnEveryShapeForEveryOrder) {
  int certified = 0, all = 0;
  std::string failed;
  for (const test::Shape& shape : test::all()) {
    const TriMesh mesh = shape.mesh();
    if (mesh.faceCount() < 12) continue;  // a tetrahedron has no room for frames
    for (int q : {2, 3, 4, 6}) {
      SuggestOptions suggest;
      suggest.q = q;
      const Result<CompleteSpec> spec = suggestCones(mesh, suggest);
      if (!spec) continue;  // refused with a reason: too few triangles for any cones
      const Result<Parametrization> p = parametrize(mesh, toSpec(*spec), {});
      ASSERT_TRUE(p) << shape.name << ": " << p.error().message;
      ++all;
      certified += p->isCertified;
      if (!p->isCertified) failed += " " + shape.name + "/q=" + std::to_string(q);
    }
  }
  EXPECT_GT(all, 50);
  EXPECT_GE(certified, all - all / 20) << "not certified:" << failed;
}

TEST(Parametrize, FramesMakeAHarmonicMapRightThatOnlyNearlyIs) {
  int framed = 0;
  for (unsigned seed : {1u, 2u, 3u, 4u, 5u, 6u})
    for (const test::Shape& base : {test::cube(8), test::icosphere(6)}) {
      const test::Shape shape = test::jittered(base, 0.3, seed);
      const Result<Parametrization> p = withItsOwnCones(shape.mesh());
      ASSERT_TRUE(p) << shape.name;
      const std::vector<Round>& rounds = p->rounds;
      if (rounds.size() < 2 || rounds[1].method != "harmonic") continue;
      EXPECT_EQ(rounds[0].constrainedTriangles, 0);
      EXPECT_GT(rounds[1].constrainedTriangles, 0);
      framed += rounds[1].flipped == 0 && rounds[1].wrongAngles == 0;
    }
  EXPECT_GE(framed, 2) << "of 12";
}

TEST(Parametrize, WhatOneLinearSystemLeavesWrongIsRepairedOnAPatch) {
  int local = 0;
  for (unsigned seed : {1u, 2u})
    for (const test::Shape& base : {test::cube(12), test::annulus(48, 12), test::pretzel(2, 6)}) {
      const test::Shape shape = test::jittered(base, 0.2, seed);
      const TriMesh mesh = shape.mesh();
      const Result<Parametrization> p = withItsOwnCones(mesh, Method::kSoft);
      expectCertified(mesh, p, shape.name);
      const std::string& last = p->rounds.back().method;
      local += last == "soft constraints, exact rows + enlarged 1, on a patch";
    }
  EXPECT_GE(local, 2) << "of 6";
}

TEST(Parametrize, SuggestedConesGiveTheSameBitsWhoeverNamesThem) {
  for (const test::Shape& shape :
       {test::jittered(test::pretzel(2, 4), 0.1), test::jittered(test::annulus(24, 8), 0.1),
        test::jittered(test::icosphere(8), 0.05), test::torus(20, 10)}) {
    const TriMesh mesh = shape.mesh();
    PreparedSurface surface(mesh);
    const Result<CompleteSpec> cones = suggestCones(surface, {});
    ASSERT_TRUE(cones) << shape.name;
    const Result<Parametrization> kept = parametrize(surface, toSpec(*cones), {});
    const Result<Parametrization> named = parametrize(mesh, toSpec(*suggestCones(mesh, {})), {});
    // Handles and turning left open are completed to the same numbers.
    HolonomySpec open = toSpec(*cones);
    open.handles.assign(open.handles.size(), std::nullopt);
    const Result<Parametrization> completed = parametrize(mesh, open, {});
    ASSERT_TRUE(kept && named && completed) << shape.name;
    EXPECT_EQ(kept->map.uv, named->map.uv) << shape.name;
    EXPECT_EQ(kept->map.uv, completed->map.uv) << shape.name;
  }
}

TEST(Parametrize, OwnConesOfGenusTwoAndThreeGiveNearIsometries) {
  for (const test::Shape& shape : {test::doubleTorus(2), test::pretzel(3, 2), test::cube(3)}) {
    const TriMesh mesh = shape.mesh();
    const Geometry geometry = computeGeometry(mesh);
    HolonomySpec spec;
    for (VertexId v : mesh.vertices()) {
      const int k = static_cast<int>(std::lround(geometry.angleSum[v] * 2 / kPi));
      if (k != 4) spec.cones.push_back({v, k});
    }
    const Result<Parametrization> p = parametrize(mesh, spec, {});
    expectCertified(mesh, p, shape.name);
    EXPECT_EQ(p->rounds.size(), 1u) << shape.name;
    EXPECT_LT(p->certificate.distortion.maxMu, 1e-3) << shape.name;
    EXPECT_LT(p->certificate.distortion.rmsLogArea, 1e-2) << shape.name;
  }
}

TEST(Parametrize, DisksAndAnnuliWithPrescribedTurning) {
  const TriMesh disk = test::disk(6).mesh();
  for (int k : {1, 2, 3, 5, 6}) {
    HolonomySpec spec;
    spec.cones = {{VertexId(0), k}};
    spec.turning = {k};  // Lemma 6.2 on a disk with one cone: 4 − k + l = 4
    const Result<Parametrization> p = parametrize(disk, spec, {});
    expectCertified(disk, p, "disk k=" + std::to_string(k));
    EXPECT_EQ(p->certificate.angles.turnings[0].measured, k);
  }
  const TriMesh annulus = test::annulus(16, 4).mesh();
  for (int l : {-4, -2, 0, 1}) {
    HolonomySpec spec;
    spec.turning = {l, -l};
    const Result<Parametrization> p = parametrize(annulus, spec, {});
    expectCertified(annulus, p, "annulus l=" + std::to_string(l));
    EXPECT_EQ(p->certificate.angles.turnings[0].measured, l);
    EXPECT_EQ(p->certificate.angles.turnings[1].measured, -l);
  }
}

TEST(Parametrize, FlatDiskMapsToItself) {
  // The conformal tie-break picks the isometry among all harmonic maps of a disk.
  for (const test::Shape& shape : {test::grid(7, 4), test::disk(5)}) {
    const TriMesh mesh = shape.mesh();
    const Result<Parametrization> p = parametrize(mesh, {}, {});
    expectCertified(mesh, p, shape.name);
    EXPECT_LT(p->certificate.distortion.maxMu, 0.05) << shape.name;
  }
}

TEST(Parametrize, PrescribedHandleRotationsAreRealised) {
  int certified = 0;
  const TriMesh mesh = test::torus(32, 20).mesh();
  HolonomySpec spec;
  const std::vector<VertexId> places = test::spreadVertices(mesh, 12);
  for (std::size_t i = 0; i < places.size(); ++i) spec.cones.push_back({places[i], i % 2 ? 3 : 5});
  for (int r = 0; r < 4; ++r) {
    spec.handles = {r, (r + 1) % 4};
    const Result<Parametrization> p = parametrize(mesh, spec, {});
    ASSERT_TRUE(p) << p.error().message;
    EXPECT_EQ(p->spec.handles, (std::vector<int>{r, (r + 1) % 4}));
    certified += p->isCertified;
    if (!p->isCertified) continue;
    EXPECT_EQ(p->certificate.seams.handles[0].measured, r);
    EXPECT_EQ(p->certificate.seams.handles[1].measured, (r + 1) % 4);
  }
  // Not every rotation is near a conformal one; what is certified has exactly what was asked.
  EXPECT_GE(certified, 2);
}

TEST(Parametrize, IsDeterministic) {
  const TriMesh mesh = test::doubleTorus(2).mesh();
  SuggestOptions suggest;
  const Result<CompleteSpec> spec = suggestCones(mesh, suggest);
  ASSERT_TRUE(spec);
  const Result<Parametrization> a = parametrize(mesh, toSpec(*spec), {});
  const Result<Parametrization> b = parametrize(mesh, toSpec(*spec), {});
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->map.uv, b->map.uv);
  EXPECT_EQ(a->map.cornerUv, b->map.cornerUv);
}

TEST(Parametrize, DoesNotDependOnTheSizeOfTheSurface) {
  test::Shape shape = test::jittered(test::icosphere(4), 0.02);
  const TriMesh mesh = shape.mesh();
  HolonomySpec spec;
  for (VertexId v : test::spreadVertices(mesh, 8)) spec.cones.push_back({v, 3});
  const Result<Parametrization> p = parametrize(mesh, spec, {});
  for (double scale : {1e-9, 1e12}) {
    test::Shape scaled = shape;
    for (Vec3& x : scaled.data.positions)
      for (double& value : x) value *= scale;
    const TriMesh other = scaled.mesh();
    const Result<Parametrization> r = parametrize(other, spec, {});
    expectCertified(other, r, "scaled");
    EXPECT_NEAR(r->certificate.distortion.meanMu, p->certificate.distortion.meanMu, 1e-4);
  }
}

}  // namespace
}  // namespace hgp
