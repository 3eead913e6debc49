#include "hgp/verify/certificate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <numbers>
#include <random>

#include "hgp/base/float32.h"
#include "hgp/base/portable_math.h"
#include "hgp/base/turns.h"
#include "hgp/verify/needed_tolerance.h"
#include "hgp/verify/verdict.h"
#include "support/maps.h"
#include "support/random.h"
#include "support/shapes.h"

namespace hgp {
namespace {

using test::developedMap;
using test::fan;
using test::Fan;
using test::flatTorusMap;
using test::planarMap;
using test::quarterFan;

bool hasReason(const Certificate& certificate, Rule rule) {
  for (const Reason& r : certificate.reasons)
    if (r.rule == rule) return true;
  return false;
}

const Reason& onlyReason(const Certificate& certificate) {
  EXPECT_EQ(certificate.reasons.size(), 1u);
  static const Reason none{};
  return certificate.reasons.empty() ? none : certificate.reasons[0];
}

std::string text(const Certificate& certificate) {
  std::string all;
  for (const Reason& r : certificate.reasons)
    all += std::string(ruleName(r.rule)) + ": " + r.message + "\n";
  return all;
}

#define EXPECT_CERTIFIED(c) EXPECT_TRUE((c).isCertified) << text(c)

HolonomySpec regular(int q) {
  HolonomySpec spec;
  spec.q = q;
  return spec;
}

/// Everything as measured: what a map may be asked to be and pass.
HolonomySpec askedAsMeasured(const Certificate& certificate) {
  HolonomySpec spec;
  spec.q = certificate.q;
  for (const MeasuredCone& c : certificate.angles.cones)
    spec.cones.push_back({c.vertex, c.measured});
  for (const MeasuredTurning& t : certificate.angles.turnings) spec.turning.push_back(t.measured);
  for (const MeasuredHandle& h : certificate.seams.handles) spec.handles.push_back(h.measured);
  return spec;
}

// ---- known good ---------------------------------------------------------------------------------

TEST(Certificate, PassesAnUnfoldedCube) {
  for (int n : {1, 2, 4}) {
    const TriMesh mesh = test::cube(n).mesh();
    HolonomySpec spec = regular(4);
    for (VertexId v : mesh.vertices()) {
      const auto& p = mesh.position(v);
      const auto isEnd = [](double x) { return x == 0.0 || x == 1.0; };
      if (isEnd(p[0]) && isEnd(p[1]) && isEnd(p[2])) spec.cones.push_back({v, 3});
    }
    ASSERT_EQ(spec.cones.size(), 8u);
    const Certificate c = certify(mesh, spec, developedMap(mesh));
    EXPECT_CERTIFIED(c);
    EXPECT_TRUE(c.isUsable);
    EXPECT_EQ(c.gaussBonnetHave, 8);
    EXPECT_EQ(c.gaussBonnetNeed, 8);
    EXPECT_EQ(c.eulerCharacteristic, 2);
    EXPECT_EQ(c.orientation.positive, mesh.faceCount());
    EXPECT_EQ(c.seams.largestRelativeResidual, 0.0);
    EXPECT_LT(c.distortion.maxMu, 1e-14);
    EXPECT_LT(c.distortion.symmetricDirichlet, 1e-13);
    EXPECT_EQ(c.angles.cones.size(), 8u);
  }
}

TEST(Certificate, AVerifierKeepsNoStateBetweenMaps) {
  const TriMesh mesh = test::cube(2).mesh();
  CertifyOptions any;
  any.isAnyConeAllowed = true;
  const UvMap right = developedMap(mesh);
  const HolonomySpec spec = askedAsMeasured(certify(mesh, regular(4), right, any));
  UvMap mirrored = right;
  for (Vec2& p : mirrored.uv) p[0] = -p[0];
  const Verifier verifier(mesh);
  for (int round = 0; round < 2; ++round) {
    EXPECT_CERTIFIED(verifier.certify(spec, right));
    EXPECT_TRUE(hasReason(verifier.certify(spec, mirrored), Rule::kOrientation));
    EXPECT_TRUE(hasReason(verifier.certify(regular(4), right), Rule::kConeAngle));
  }
}

TEST(Certificate, PassesAFlatTorus) {
  const TriMesh mesh = test::torus(6, 4).mesh();
  for (int q : {1, 2, 3, 4, 7}) {
    HolonomySpec spec = regular(q);
    spec.handles = {0, 0};
    const Certificate c = certify(mesh, spec, flatTorusMap(6, 4));
    EXPECT_CERTIFIED(c);
    EXPECT_EQ(c.seams.seams.size(), 10u);
    EXPECT_EQ(c.seams.chartCount, 1);
    EXPECT_TRUE(c.angles.cones.empty());
    for (const MeasuredSeam& s : c.seams.seams) EXPECT_EQ(s.r, 0);
  }
}

TEST(Certificate, PassesAConvexDisk) {
  for (const test::Shape& shape : {test::triangle(), test::disk(4), test::grid(3, 5)}) {
    const TriMesh mesh = shape.mesh();
    for (int q : {1, 4, 6}) {
      HolonomySpec spec = regular(q);
      spec.turning = {q};
      const Certificate c = certify(mesh, spec, planarMap(mesh));
      EXPECT_CERTIFIED(c) << shape.name;
      EXPECT_TRUE(c.angles.overlapping.empty());
      EXPECT_TRUE(c.seams.seams.empty());
    }
  }
}

TEST(Certificate, PassesAnAnnulusWithTurningsThatCancel) {
  const TriMesh mesh = test::annulus(12, 3).mesh();
  HolonomySpec spec = regular(4);
  spec.turning = {4, -4};
  Certificate c = certify(mesh, spec, planarMap(mesh));
  if (!c.isCertified) {  // which loop is the outer one is not the point
    spec.turning = {-4, 4};
    c = certify(mesh, spec, planarMap(mesh));
  }
  EXPECT_CERTIFIED(c);
}

TEST(Certificate, PassesFlatConesOfEveryAngle) {
  for (int q : {1, 2, 3, 5, 6, 7, 64})
    for (int k = 1; k < 3 * q; k += 1 + q / 7) {
      const int n = std::max(3, 1 + 3 * k / q);
      const Fan f = fan(n, turnAngle(k, q));
      HolonomySpec spec = regular(q);
      spec.cones = {{VertexId(0), k}};
      spec.turning = {k};  // Gauss–Bonnet: (q − k) + l = q
      const Certificate c = certify(f.mesh, spec, f.map);
      EXPECT_CERTIFIED(c) << "q=" << q << " k=" << k;
      EXPECT_LT(c.angles.worstDistance, 1e-12);
    }
}

TEST(Certificate, PassesDevelopedSurfacesOfEveryGenusWithTheirOwnHolonomy) {
  for (const test::Shape& shape :
       {test::cube(2), test::pretzel(1), test::doubleTorus(), test::pretzel(5)}) {
    const TriMesh mesh = shape.mesh();
    const UvMap map = developedMap(mesh);
    CertifyOptions options;
    options.isAnyConeAllowed = true;
    const Certificate measured = certify(mesh, regular(4), map, options);
    EXPECT_CERTIFIED(measured);
    const HolonomySpec spec = askedAsMeasured(measured);
    EXPECT_CERTIFIED(certify(mesh, spec, map));
    EXPECT_EQ(measured.gaussBonnetHave, 4 * shape.eulerCharacteristic());
    EXPECT_EQ(measured.seams.handles.size(), static_cast<std::size_t>(2 * shape.genus));
    EXPECT_EQ(measured.genus, shape.genus);
    // Every prescription that differs in one number is refused for that number.
    for (std::size_t n = 0; n < spec.handles.size(); ++n) {
      HolonomySpec other = spec;
      other.handles[n] = *other.handles[n] + 1;
      EXPECT_EQ(onlyReason(certify(mesh, other, map)).rule, Rule::kHandle);
    }
    for (std::size_t n = 0; n < spec.cones.size(); ++n) {
      HolonomySpec other = spec;
      other.cones[n].k += 1;
      const Reason reason = onlyReason(certify(mesh, other, map));
      EXPECT_EQ(reason.rule, Rule::kConeAngle);
      EXPECT_EQ(reason.where[0].id, spec.cones[n].vertex.i);
    }
  }
}

// ---- laws ---------------------------------------------------------------------------------------

TEST(Certificate, SeamRotationsAroundAConeAddUpToMinusK) {
  const TriMesh mesh = test::doubleTorus().mesh();
  CertifyOptions options;
  options.isAnyConeAllowed = true;
  const Certificate c = certify(mesh, regular(4), developedMap(mesh), options);
  PerEdge<int> r(static_cast<std::size_t>(mesh.edgeCount()), 0);
  for (const MeasuredSeam& s : c.seams.seams) r[s.edge] = s.r;
  PerVertex<int> k(static_cast<std::size_t>(mesh.vertexCount()), 4);
  for (const MeasuredCone& cone : c.angles.cones) k[cone.vertex] = cone.measured;
  for (VertexId v : mesh.vertices()) {
    int sum = 0;
    // Going round counterclockwise leaves each face through the side that points at v.
    for (HalfedgeId h : outgoingHalfedges(mesh, v)) {
      const HalfedgeId crossed = TriMesh::previous(h);
      const EdgeId e = mesh.edge(crossed);
      sum += crossed == mesh.halfedge(e) ? r[e] : -r[e];
    }
    EXPECT_EQ(reduceTurn(sum, 4), reduceTurn(-k[v], 4));
  }
}

TEST(Certificate, HandleRotationsAreTheTransportOfUvAlongTheLoop) {
  for (int genus : {1, 2, 3}) {
    // Developed from the far end, so that loops cross many seams in both directions.
    const TriMesh mesh = test::pretzel(genus).mesh();
    const UvMap map = developedMap(mesh, FaceId(mesh.faceCount() - 1));
    const auto side = [&](HalfedgeId h) {  // the uv vector of h in its own face
      const auto at = [&](HalfedgeId c) {
        const Vec2& p = map.uv[static_cast<std::size_t>(
            map.cornerUv[static_cast<std::size_t>(c.i / 3)][static_cast<std::size_t>(c.i % 3)])];
        return Complex(p[0], p[1]);
      };
      return at(TriMesh::next(h)) - at(h);
    };
    const std::vector<DualLoop> loops = handleGenerators(mesh);
    const Certificate c = certify(mesh, regular(4), map);
    ASSERT_EQ(c.seams.handles.size(), loops.size());
    bool isAnyRotated = false;
    for (std::size_t n = 0; n < loops.size(); ++n) {
      Complex turned = 1.0;
      for (HalfedgeId h : loops[n].crossed) turned *= -side(mesh.twin(h)) / side(h);
      ASSERT_TRUE(c.seams.handles[n].measured.has_value());
      EXPECT_NEAR(std::abs(turned - rotation(*c.seams.handles[n].measured, 4)), 0.0, 1e-12);
      isAnyRotated = isAnyRotated || *c.seams.handles[n].measured % 2 == 1;
    }
    EXPECT_TRUE(isAnyRotated) << "a loop with an odd rotation tells r from −r";
  }
}

TEST(Certificate, DoesNotDependOnRotationScaleOrPlaceOfTheMap) {
  const TriMesh mesh = test::pretzel(1).mesh();
  const UvMap map = developedMap(mesh);
  CertifyOptions options;
  options.isAnyConeAllowed = true;
  const HolonomySpec spec = askedAsMeasured(certify(mesh, regular(4), map, options));
  for (double scale : {1.0, 0x1p-900, 0x1p+900, 0x1p-1060, 1e-3, 3e5})
    for (double shift : {0.0, 17.0}) {
      UvMap moved = map;
      for (Vec2& p : moved.uv) p = {scale * (shift - p[1]), scale * (p[0] - shift)};
      const Certificate c = certify(mesh, spec, moved);
      EXPECT_CERTIFIED(c) << scale << " " << shift;
      EXPECT_NEAR(c.distortion.areaSpan, 1.0, 1e-9);
      const double mean = (2.0 + std::sqrt(2.0)) / 3.0 * scale;
      EXPECT_NEAR(c.seams.meanEdge / mean, 1.0, 1e-9);
      if (scale > 1e-290) {
        EXPECT_EQ(c.thresholds.tolerance, kTolerance);
        EXPECT_EQ(c.thresholds.rounding, 0.0);
      }
    }
}

TEST(Certificate, WindingAroundAVertexIsCountedExactly) {
  // Rings of integer points that go round w times, checked by counting crossings in integers.
  std::mt19937 random(5);
  for (int round = 0; round < 300; ++round) {
    const int w = 1 + static_cast<int>(random() % 3), n = 4 * w + static_cast<int>(random() % 9);
    std::vector<Vec2> spokes;
    for (int i = 0; i < n; ++i) {
      const double angle =
          2 * kPi * w * (i + 0.3 * static_cast<double>(random() % 100) / 100.0) / n;
      const double radius = 1000.0 + static_cast<double>(random() % 100000);
      spokes.push_back(
          {std::round(radius * std::cos(angle)), std::round(radius * std::sin(angle))});
    }
    long long crossings = 0;  // of the positive u axis, upwards minus downwards
    for (std::size_t i = 0; i < spokes.size(); ++i) {
      const Vec2 &a = spokes[i], &b = spokes[(i + 1) % spokes.size()];
      const double side = a[0] * b[1] - a[1] * b[0];
      if (a[1] < 0 && b[1] >= 0 && side > 0) ++crossings;
      if (a[1] >= 0 && b[1] < 0 && side < 0) --crossings;
    }
    ASSERT_EQ(crossings, w);
    Fan f = quarterFan(n);
    std::vector<Vec2> corners;
    for (std::size_t i = 0; i < spokes.size(); ++i) {
      corners.push_back({0, 0});
      corners.push_back(spokes[i]);
      corners.push_back(spokes[(i + 1) % spokes.size()]);
    }
    for (int q : {1, 2, 3, 4, 5, 6, 7, 11}) {
      HolonomySpec spec = regular(q);
      spec.cones = {{VertexId(0), w * q}};
      spec.turning = {w * q};
      const Certificate c = certify(f.mesh, spec, test::mapOfCorners(f.mesh, corners));
      EXPECT_CERTIFIED(c);
    }
  }
}

TEST(Certificate, SeamsOfIntegerMapsTurnExactly) {
  // Two unit squares' worth of triangles whose charts are turned by r quarter turns and moved.
  const TriMesh mesh = test::grid(1, 1).mesh();
  for (int q : {1, 2, 4})
    for (int r = 0; r < q; ++r) {
      UvMap map = planarMap(mesh);
      const Complex R = rotation(r, q);
      std::vector<Vec2> corners;
      for (HalfedgeId h : mesh.halfedges()) {
        const Vec3& p = mesh.position(mesh.tail(h));
        Complex z(p[0], p[1]);
        if (TriMesh::face(h).i == 1) z = R * z + Complex(1000003.0, -77.0);
        corners.push_back({z.real(), z.imag()});
      }
      HolonomySpec spec = regular(q);
      spec.turning = {q};
      const Certificate c = certify(mesh, spec, test::mapOfCorners(mesh, corners));
      EXPECT_CERTIFIED(c);
      ASSERT_EQ(c.seams.seams.size(), 1u);
      EXPECT_EQ(c.seams.seams[0].r, r);
      EXPECT_EQ(c.seams.seams[0].residual, 0.0);
      EXPECT_EQ(c.seams.chartCount, 2);
    }
}

TEST(Certificate, DistortionOfALinearMapIsTheClosedForm) {
  const TriMesh mesh = test::jittered(test::grid(9, 7), 0.0).mesh();
  const double a = 3.0, b = 0.5;
  UvMap map = planarMap(mesh);
  for (Vec2& p : map.uv) p = {a * p[0], b * p[1]};
  const DistortionFacts d = certify(mesh, regular(4), map).distortion;
  const double mu = (a - b) / (a + b);
  EXPECT_NEAR(d.meanMu, mu, 1e-14);
  EXPECT_NEAR(d.p95Mu, mu, 1e-14);
  EXPECT_NEAR(d.maxMu, mu, 1e-14);
  EXPECT_NEAR(d.medianMu, mu, 1e-14);
  EXPECT_NEAR(d.sizeSpread, 1.0, 1e-13);
  EXPECT_NEAR(d.rmsLogArea, 0.0, 1e-13);
  EXPECT_NEAR(d.symmetricDirichlet, 2 * (a / b + b / a) - 4, 1e-12);
  EXPECT_EQ(d.triangleCount, mesh.faceCount());
}

TEST(Certificate, DistortionAgreesWithSingularValuesAndASortedList) {
  const TriMesh mesh = test::jittered(test::grid(13, 11), 0.1).mesh();
  UvMap map = planarMap(mesh);
  for (Vec2& p : map.uv) p = {std::exp(0.1 * p[0]) + 0.05 * p[1], p[1] * (1 + 0.05 * p[0])};
  const DistortionFacts d = certify(mesh, regular(4), map).distortion;
  ASSERT_EQ(d.triangleCount, mesh.faceCount());
  // Singular values from the metric tensors, in another way than the verifier's.
  std::vector<std::pair<double, double>> mu, size;
  double total = 0, sum = 0;
  for (FaceId f : mesh.faces()) {
    const auto t = mesh.corners(f);
    double G[3] = {}, H[3] = {};
    const auto uv = [&](int k) {
      return map.uv[static_cast<std::size_t>(t[static_cast<std::size_t>(k)].i)];
    };
    for (std::size_t n = 0; n < 3; ++n) {
      const double p = mesh.position(t[1])[n] - mesh.position(t[0])[n];
      const double q = mesh.position(t[2])[n] - mesh.position(t[0])[n];
      G[0] += p * p, G[1] += p * q, G[2] += q * q;
    }
    for (std::size_t n = 0; n < 2; ++n) {
      const double p = uv(1)[n] - uv(0)[n], q = uv(2)[n] - uv(0)[n];
      H[0] += p * p, H[1] += p * q, H[2] += q * q;
    }
    const double det = G[0] * G[2] - G[1] * G[1];
    const double trace = (H[0] * G[2] - 2 * H[1] * G[1] + H[2] * G[0]) / det;
    const double product = std::sqrt((H[0] * H[2] - H[1] * H[1]) / det);
    const double plus = std::sqrt(trace + 2 * product), minus = std::sqrt(trace - 2 * product);
    mu.emplace_back(minus / plus, 0.5 * std::sqrt(det));
    size.emplace_back(std::sqrt(product), 0.5 * std::sqrt(det));
    total += mu.back().second;
    sum += mu.back().first * mu.back().second;
  }
  EXPECT_NEAR(d.meanMu, sum / total, 1e-12);
  const auto quantile = [&](std::vector<std::pair<double, double>>& values, double share) {
    std::sort(values.begin(), values.end());
    double below = 0;
    for (const auto& [value, weight] : values) {
      below += weight;
      if (below >= share * total) return value;
    }
    return values.back().first;
  };
  EXPECT_NEAR(d.p95Mu, quantile(mu, 0.95), 1e-12);
  EXPECT_NEAR(d.medianMu, quantile(mu, 0.5), 1e-12);
  EXPECT_NEAR(d.maxMu, mu.back().first, 1e-12);
  // The scale of a size is the root of that of areas.
  EXPECT_NEAR(d.sizeSpread, quantile(size, 0.95) / quantile(size, 0.05), 1e-12);
}

TEST(Certificate, QuantileIsWeightedByArea) {
  // One large triangle with μ = 0 and many small stretched ones holding 4 % of the area.
  MeshData data;
  UvMap map;
  data.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  data.triangles = {{0, 1, 2}};
  map.uv = {{0, 0}, {1, 0}, {0, 1}};
  for (int n = 0; n < 10; ++n) {
    const double x = 10.0 + n, s = std::sqrt(0.04 / 10);
    const int id = static_cast<int>(data.positions.size());
    data.positions.insert(data.positions.end(), {{x, 0, 0}, {x + s, 0, 0}, {x, s, 0}});
    data.triangles.push_back({id, id + 1, id + 2});
    map.uv.insert(map.uv.end(), {{x, 0}, {x + 3 * s, 0}, {x, s}});
  }
  map.cornerUv = data.triangles;
  const DistortionFacts d = certify(test::meshOf(data), regular(4), map).distortion;
  EXPECT_EQ(d.p95Mu, 0.0);
  EXPECT_NEAR(d.maxMu, 0.5, 1e-12);
  EXPECT_NEAR(d.meanMu, 0.5 * 0.04 / 1.04, 1e-12);
}

// ---- what must be caught ------------------------------------------------------------------------

TEST(Certificate, CatchesAFlippedTriangleOfArea1e300) {
  // Two triangles over a diagonal; the fourth corner lies on the wrong side of it.
  const TriMesh mesh = test::grid(1, 1).mesh();
  const double s = 1e-150;
  UvMap map = planarMap(mesh);
  ASSERT_EQ(map.uv.size(), 4u);
  for (Vec2& p : map.uv) p = {p[0] * s, p[1] * s};
  EXPECT_CERTIFIED(certify(mesh, regular(4), map));
  map.uv[2] = {0.5 * s, 0.499 * s};
  const Certificate c = certify(mesh, regular(4), map);
  EXPECT_FALSE(c.isCertified);
  EXPECT_TRUE(hasReason(c, Rule::kOrientation)) << text(c);
  EXPECT_EQ(c.orientation.negative, 1);
  ASSERT_EQ(c.orientation.notPositive.size(), 1u);
  EXPECT_EQ(c.orientation.notPositive[0], FaceId(1));
}

TEST(Certificate, CatchesATriangleFlippedByTheLastBit) {
  const TriMesh mesh = test::disk(5).mesh();
  UvMap map = planarMap(mesh);
  // The centre goes to the middle of a side of the hexagon around it, then a last bit outwards.
  ASSERT_EQ(mesh.corners(FaceId(0))[0], VertexId(0));
  const Vec2 b = map.uv[1], c = map.uv[2];
  Vec2& a = map.uv[0];
  a = {(b[0] + c[0]) / 2, (b[1] + c[1]) / 2};
  while (orientationSign(a, b, c) >= 0) a[0] = std::nextafter(a[0], 2.0);
  const Certificate certificate = certify(mesh, regular(4), map);
  EXPECT_FALSE(certificate.isCertified);
  EXPECT_TRUE(hasReason(certificate, Rule::kOrientation));
  EXPECT_EQ(certificate.orientation.negative, 1);
  EXPECT_GT(certificate.reasons[0].worst, -1e-12);
  while (orientationSign(a, b, c) <= 0) a[0] = std::nextafter(a[0], -2.0);
  // Positive, but as small as that no double holds it.
  EXPECT_EQ(onlyReason(certify(mesh, regular(4), map)).rule, Rule::kRange);
  a[0] = (b[0] + c[0]) / 2 - 1e-14;
  EXPECT_CERTIFIED(certify(mesh, regular(4), map));
}

TEST(Certificate, CatchesAZeroAreaTriangle) {
  const TriMesh mesh = test::grid(1, 1).mesh();
  UvMap map = planarMap(mesh);
  map.uv[2] = {0.5, 0.5};  // on the diagonal
  const Certificate c = certify(mesh, regular(4), map);
  EXPECT_FALSE(c.isCertified);
  EXPECT_EQ(c.orientation.zero, 1);
  EXPECT_TRUE(hasReason(c, Rule::kOrientation));
  map.uv[2] = map.uv[0];
  EXPECT_FALSE(certify(mesh, regular(4), map).isCertified);
  for (Vec2& p : map.uv) p = {0, 0};
  EXPECT_EQ(certify(mesh, regular(4), map).orientation.zero, 2);
}

TEST(Certificate, CatchesFourPiWhereTwoPiWasAsked) {
  const Fan cover = quarterFan(8);
  for (int q : {1, 2, 4, 5}) {
    const Certificate c = certify(cover.mesh, regular(q), cover.map);
    const Reason reason = onlyReason(c);
    EXPECT_FALSE(c.isCertified);
    EXPECT_EQ(reason.rule, Rule::kConeAngle) << text(c);
    EXPECT_EQ(reason.where[0].id, 0);
    EXPECT_EQ(reason.worst, q);
    EXPECT_EQ(c.orientation.positive, 8);
    EXPECT_TRUE(c.seams.seams.empty());
    ASSERT_EQ(c.angles.cones.size(), 1u);
    EXPECT_EQ(c.angles.cones[0].measured, 2 * q);
    HolonomySpec asked = regular(q);
    asked.cones = {{VertexId(0), 2 * q}};
    asked.turning = {2 * q};
    EXPECT_CERTIFIED(certify(cover.mesh, asked, cover.map));
  }
}

/// A flat torus, one copy of a seam vertex moved by `shift` uv units (its seam edges have length 1).
UvMap shiftedTorus(double shift) {
  UvMap map = flatTorusMap(6, 4);
  for (Vec2& p : map.uv)
    if (p == Vec2{0, 2}) p[1] += shift;  // the copy at (6, 2) stays
  return map;
}

TEST(Certificate, CatchesASeamOffByMoreThanAMillionthOfItsOwnLength) {
  const TriMesh mesh = test::torus(6, 4).mesh();
  EXPECT_CERTIFIED(certify(mesh, regular(4), shiftedTorus(0)));
  EXPECT_CERTIFIED(certify(mesh, regular(4), shiftedTorus(0.9e-6)));
  const Certificate c = certify(mesh, regular(4), shiftedTorus(1.1e-6));
  EXPECT_FALSE(c.isCertified);
  const Reason reason = onlyReason(c);
  EXPECT_EQ(reason.rule, Rule::kSeam) << text(c);
  EXPECT_EQ(reason.count, 2);
  EXPECT_NEAR(c.seams.largestRelativeResidual, 1.1e-6, 1e-11);
  EXPECT_NEAR(neededTolerance(c).seam, 1.1e-6, 1e-11);
  CertifyOptions coarse;
  coarse.tolerance = 1.0001 * neededTolerance(c).seam;
  EXPECT_CERTIFIED(certify(mesh, regular(4), shiftedTorus(1.1e-6), coarse));
  coarse.tolerance = 0.9999 * neededTolerance(c).seam;
  EXPECT_FALSE(certify(mesh, regular(4), shiftedTorus(1.1e-6), coarse).isCertified);
}

TEST(Certificate, ASeamIsMeasuredByItsOwnLengthHoweverLargeTheMapIs) {
  // The wrench of the reviewers: a tenth of an edge is nothing beside the largest coordinate.
  const Fan f = quarterFan(3);
  HolonomySpec spec = regular(4);
  spec.cones = {{VertexId(0), 3}};
  for (const auto& [shift, size] : {std::pair{0.1, 0x1p-46}, {1e-3, 0x1p-40}, {1e-5, 0x1p-34}}) {
    UvMap map = f.map;
    for (Vec2& p : map.uv)
      if (p == Vec2{1, 0}) p[0] += shift;
    for (Vec2& p : map.uv) p = {p[0] * size + 1.0, p[1] * size + 1.0};
    const Certificate c = certify(f.mesh, spec, map);
    EXPECT_FALSE(c.isCertified) << shift;
    for (const Reason& r : c.reasons) EXPECT_EQ(r.rule, Rule::kRange) << text(c);
    EXPECT_NE(c.reasons.at(0).message.find("beyond float64"), std::string::npos);
    EXPECT_FALSE(c.reasons[0].where.empty());
  }
}

TEST(Certificate, CatchesASeamTurnedByAnAngleThatIsNoMultiple) {
  const Fan f = fan(5, turnAngle(3, 4));
  HolonomySpec spec = regular(4);
  spec.cones = {{VertexId(0), 3}};
  EXPECT_CERTIFIED(certify(f.mesh, spec, f.map));
  spec.q = 3;
  spec.cones[0].k = 2;
  const Certificate c = certify(f.mesh, spec, f.map);
  EXPECT_TRUE(hasReason(c, Rule::kSeam));
  EXPECT_TRUE(hasReason(c, Rule::kConeAngle));
}

TEST(Certificate, CatchesASeamOfUnequalLength) {
  const Fan f = fan(5, turnAngle(3, 4));
  UvMap map = f.map;
  for (Vec2& p : map.uv)
    if (p == Vec2{1, 0}) p[0] += 1e-5;
  HolonomySpec spec = regular(4);
  spec.cones = {{VertexId(0), 3}};
  const Certificate c = certify(f.mesh, spec, map);
  EXPECT_EQ(onlyReason(c).rule, Rule::kSeam) << text(c);
  EXPECT_NEAR(c.seams.worstLengthResidual, 1e-5, 1e-9);
}

TEST(Certificate, CatchesATurningIndexOffByOne) {
  const TriMesh mesh = test::disk(3).mesh();
  for (int l : {3, 5}) {
    HolonomySpec spec = regular(4);
    spec.turning = {l};
    const Certificate c = certify(mesh, spec, planarMap(mesh));
    EXPECT_FALSE(c.isCertified);
    EXPECT_EQ(onlyReason(c).rule, Rule::kTurning);
    EXPECT_EQ(c.angles.turnings[0].measured, 4);
  }
}

TEST(Certificate, CatchesAHandleRotationOffByOne) {
  const TriMesh mesh = test::torus(6, 4).mesh();
  HolonomySpec spec = regular(4);
  spec.handles = {0, 1};
  const Certificate c = certify(mesh, spec, flatTorusMap(6, 4));
  EXPECT_EQ(onlyReason(c).rule, Rule::kHandle);
  spec.handles = {4, -8};  // classes mod q
  EXPECT_CERTIFIED(certify(mesh, spec, flatTorusMap(6, 4)));
  spec.handles = {std::nullopt, 0};
  EXPECT_CERTIFIED(certify(mesh, spec, flatTorusMap(6, 4)));
}

TEST(Certificate, CatchesAConeThatWasNotAsked) {
  const TriMesh mesh = test::cube(1).mesh();
  HolonomySpec spec = regular(4);
  for (int v = 0; v < 7; ++v) spec.cones.push_back({VertexId(v), 3});
  const Certificate c = certify(mesh, spec, developedMap(mesh));
  const Reason reason = onlyReason(c);
  EXPECT_EQ(reason.rule, Rule::kConeAngle);
  EXPECT_EQ(reason.where[0].id, 7);
}

UvMap roundedToFloat32(UvMap map) {
  for (Vec2& p : map.uv) p = {roundToFloat(p[0]), roundToFloat(p[1])};
  return map;
}

TEST(Certificate, CatchesWhatRoundingToFloatDoes) {
  const TriMesh mesh = test::grid(1, 1).mesh();
  UvMap map = planarMap(mesh);
  map.uv[2] = {0.5, 0.5 + 1e-12};
  CertifyOptions options;
  EXPECT_CERTIFIED(certify(mesh, regular(4), map, options));
  options.precision = Precision::kFloat32;
  const Certificate given = certify(mesh, regular(4), map, options);
  EXPECT_EQ(given.orientation.zero, 0) << "it is verified as it is given";
  EXPECT_EQ(onlyReason(given).rule, Rule::kRange);
  const Certificate c = certify(mesh, regular(4), roundedToFloat32(map), options);
  EXPECT_FALSE(c.isCertified);
  EXPECT_EQ(c.orientation.zero, 1);
  map.uv[2] = {0.5, 1e300};
  EXPECT_EQ(onlyReason(certify(mesh, regular(4), roundedToFloat32(map), options)).rule,
            Rule::kNotFinite);
}

TEST(Certificate, AllowsWhatRoundingToFloatCanDoAndNoMore) {
  const Fan f = fan(7, turnAngle(5, 6));
  HolonomySpec spec = regular(6);
  spec.cones = {{VertexId(0), 5}};
  CertifyOptions single;
  single.precision = Precision::kFloat32;
  const auto rounded = [&](const Vec2& shift, double scale) {
    UvMap map = f.map;
    for (Vec2& p : map.uv) {
      p = {roundToFloat(scale * p[0] + shift[0]), roundToFloat(scale * p[1] + shift[1])};
    }
    return map;
  };
  for (double scale : {1.0, 1e-2, 3e-4}) {
    const UvMap map = rounded({0.7, 0.3}, scale);
    EXPECT_EQ(certify(f.mesh, spec, map).isCertified, scale == 1.0) << "as doubles they are torn";
    const Certificate c = certify(f.mesh, spec, map, single);
    EXPECT_CERTIFIED(c) << scale;
    const double largest = c.seams.maxUv;
    EXPECT_EQ(c.thresholds.rounding,
              (largest >= 1 ? 0x1p-23 : 0x1p-24) * 4 * std::numbers::sqrt2 / 2);
    ASSERT_TRUE(c.seams.worst);
    EXPECT_GT(c.seams.worst->allowed, c.seams.worst->residual);
    EXPECT_LE(c.seams.worst->allowed, c.thresholds.rounding + kTolerance * c.seams.worst->length);
  }
  // What rounding cannot have done is not excused …
  UvMap map = rounded({0.7, 0.3}, 1.0);
  const Vec2 spoke = map.uv[static_cast<std::size_t>(map.cornerUv[0][1])];
  for (Vec2& p : map.uv)
    if (p == spoke) p[0] += 0x1p-19;
  EXPECT_TRUE(hasReason(certify(f.mesh, spec, map, single), Rule::kSeam));
  // … nor what it can have done where it is coarse beside the edges.
  int refused = 0;
  for (double scale : {1e-4, 1e-5, 0.7e-5, 0.4e-5, 0.2e-5, 1e-6, 5e-7}) {
    const Certificate c = certify(f.mesh, spec, rounded({0.7, 0.3}, scale), single);
    if (c.isCertified) {
      EXPECT_LE(neededTolerance(c).seam, kLargestRounding);
      EXPECT_LE(neededTolerance(c).angle, kLargestRounding);
      continue;
    }
    ++refused;
    EXPECT_TRUE(hasReason(c, Rule::kRange) || hasReason(c, Rule::kOrientation)) << text(c);
  }
  EXPECT_GT(refused, 1);
}

TEST(Certificate, HasNoRotationForASeamTooShortToHaveADirection) {
  // A seam as long as the ulp of its coordinates, off by half of it: any rotation would do as well.
  const Fan f = quarterFan(3);
  HolonomySpec spec = regular(4);
  spec.cones = {{VertexId(0), 3}};
  const auto shrink = [&](double size) {
    UvMap map = f.map;
    for (Vec2& p : map.uv) p = {1.0 + p[0] * size, p[1] * size};
    for (Vec2& p : map.uv)
      if (p[0] > 1.0) p[0] += 0x1p-49;
    return certify(f.mesh, spec, map);
  };
  EXPECT_CERTIFIED(shrink(0x1p-28));
  const Certificate c = shrink(0x1p-48);
  EXPECT_FALSE(c.isCertified);
  ASSERT_FALSE(c.seams.broken.empty());
  EXPECT_FALSE(c.seams.broken[0].hasRotation);
}

TEST(Certificate, AnglesHaveNoSlackThatTheirSeamsDoNotHave) {
  // The seam alone is turned by 2⁻⁹ of its length, far less than its neighbours in the plane see.
  const Fan f = quarterFan(3);
  UvMap map = f.map;
  for (Vec2& p : map.uv) p = {1.0 + p[0] * 0x1p-40, p[1] * 0x1p-40 + (p[0] == 1.0 ? 0x1p-49 : 0.0)};
  HolonomySpec spec = regular(4);
  spec.cones = {{VertexId(0), 3}};
  const Certificate c = certify(f.mesh, spec, map);
  EXPECT_FALSE(c.isCertified);
  ASSERT_EQ(c.angles.wrong.size(), 1u);
  EXPECT_EQ(c.angles.wrong[0].measured, c.angles.wrong[0].asked);
  EXPECT_GT(c.angles.worstDistance, 100 * kTolerance);
  EXPECT_EQ(onlyReason(c).rule, Rule::kRange) << text(c);
}

TEST(Distortion, AVerdictWithoutItIsTheSame) {
  const Fan f = quarterFan(3);
  CertifyOptions brief;
  brief.measuresDistortion = false;
  const auto text = [](const Certificate& c) {
    std::string out;
    for (const Reason& reason : c.reasons) out += reason.message;
    return out;
  };
  // As it is, with a triangle nearly crushed, one crushed and one reversed.
  for (double part : {1.0, 1e-9, 1e-17, 1e-200, 0.0, -1.0}) {
    UvMap map = f.map;
    const auto [a, b, c] = map.cornerUv[0];
    const auto uv = [&](int n) -> Vec2& { return map.uv[static_cast<std::size_t>(n)]; };
    for (std::size_t k = 0; k < 2; ++k) uv(c)[k] = uv(a)[k] + part * (uv(c)[k] - uv(a)[k]);
    const Certificate whole = certify(f.mesh, regular(4), map);
    const Certificate verdict = certify(f.mesh, regular(4), map, brief);
    EXPECT_EQ(verdict.isCertified, whole.isCertified) << part;
    EXPECT_EQ(verdict.isUsable, whole.isUsable) << part;
    EXPECT_EQ(text(verdict), text(whole)) << part;
    EXPECT_EQ(verdict.distortion.triangleCount, whole.distortion.triangleCount);
    EXPECT_EQ(verdict.distortion.areaSpan, whole.distortion.areaSpan);
    EXPECT_EQ(verdict.distortion.smallestToMeanArea, whole.distortion.smallestToMeanArea);
    EXPECT_EQ(verdict.distortion.smallestArea, whole.distortion.smallestArea);
    EXPECT_EQ(verdict.distortion.maxMu, 0.0);
    EXPECT_GT(whole.distortion.maxMu, 0.0);
  }
}

TEST(Angles, AreMeasuredInRadiansWhateverTheOrder) {
  // measureAngles alone: the seam rule sees such maps first.
  const Fan f = quarterFan(3);
  const Topology topology = computeTopology(f.mesh);
  for (int q : {4, 8, 64}) {
    AskedAngles asked;
    asked.q = q;
    asked.k = PerVertex<int>(static_cast<std::size_t>(f.mesh.vertexCount()), 0);
    asked.isCone = PerVertex<char>(static_cast<std::size_t>(f.mesh.vertexCount()), 0);
    asked.k[VertexId(0)] = 3 * q / 4;
    asked.turning = {std::nullopt};
    AngleRule rule;
    rule.tolerance = kTolerance;
    rule.rounding = rule.explained =
        PerVertex<double>(static_cast<std::size_t>(f.mesh.vertexCount()), 0.0);
    for (double off : {0.0, 0.9e-6, 1.1e-6, -1.1e-6}) {
      CornerUv uv(static_cast<std::size_t>(f.mesh.halfedgeCount()));
      for (HalfedgeId h : f.mesh.halfedges())
        uv[h] = f.map.uv[static_cast<std::size_t>(
            f.map.cornerUv[static_cast<std::size_t>(h.i / 3)][static_cast<std::size_t>(h.i % 3)])];
      PerHalfedge<AngleVector> angle = computeUvAngles(f.mesh, uv);
      const auto turn = [off](AngleVector& a) {
        a = {a[0] * std::cos(off) - a[1] * std::sin(off),
             a[0] * std::sin(off) + a[1] * std::cos(off)};
      };
      turn(angle[f.mesh.outgoing(VertexId(0))]);
      const AngleFacts facts = measureAngles(f.mesh, topology, asked, angle, rule);
      EXPECT_EQ(facts.wrong.empty(), std::fabs(off) < kTolerance) << q << " " << off;
      EXPECT_NEAR(facts.worstDistance, std::fabs(off), 1e-14);
      // The same at the boundary, where the loop's turning carries it.
      angle = computeUvAngles(f.mesh, uv);
      turn(angle[topology.loops[0].halfedges[1]]);
      const AngleFacts turned = measureAngles(f.mesh, topology, asked, angle, rule);
      EXPECT_EQ(turned.turnings[0].isWrong, std::fabs(off) >= kTolerance) << q << " " << off;
    }
  }
}

TEST(Angles, AddUpWhateverTheirNumberAndSize) {
  const auto vectorOf = [](double angle, double length) {
    return AngleVector{length * std::cos(angle), std::max(0.0, length * std::sin(angle))};
  };
  std::mt19937 random(7);
  const auto share = [&] { return 0.5 + 0.5 * test::randomReal(random); };
  for (int n = 0; n < 2000; ++n) {
    AngleSum sum;
    long double expected = 0.0;
    const int count = test::randomBelow(random, n % 10 == 0 ? 3000 : 12);
    for (int i = 0; i < count; ++i) {
      const double angle = kPi * std::pow(share(), n % 3 + 1);
      sum.add(vectorOf(angle, 1.0 + 0.4 * share()));
      expected += angle;
    }
    const auto rounded = static_cast<double>(expected);
    EXPECT_NEAR(sum.radians(), rounded, 4e-16 * (count + rounded)) << count;
  }
}

TEST(Angles, OfHalfAndFullTurnsAreCountedOnce) {
  const AngleVector zero{1.0, 0.0}, right{0.0, 1.0}, half{-1.0, 0.0};
  using Angles = std::vector<AngleVector>;
  const std::vector<std::pair<Angles, double>> cases = {
      {{}, 0.0},
      {{zero, zero}, 0.0},
      {{half}, kPi},
      {{half, zero, zero}, kPi},
      {{zero, half, half}, 2 * kPi},
      {{half, half, half}, 3 * kPi},
      {{half, right, right}, 2 * kPi},
      {{right, right, half, zero}, 2 * kPi},
      {{right, half, right}, 2 * kPi},
      {{right, right, right, right, right}, 2.5 * kPi},
      {{half, half, half, half, right}, 4.5 * kPi}};
  for (const auto& [angles, expected] : cases) {
    AngleSum sum;
    for (const AngleVector& angle : angles) sum.add(angle);
    EXPECT_NEAR(sum.radians(), expected, 1e-15) << angles.size();
  }
}

TEST(Seams, TurnsAreTheAnglesThatResidualsCanMake) {
  const TriMesh mesh = test::grid(2, 2).mesh();
  SeamFacts seams;
  MeasuredSeam seam;
  for (EdgeId e : mesh.edges())
    if (!mesh.isBoundary(mesh.halfedge(e))) seam.edge = e;
  seam.residual = 1e-3;
  seam.length = 2.0;
  seam.isExplained = true;
  seams.seams = {seam};
  const VertexId v = mesh.tail(mesh.halfedge(seam.edge));
  SeamRule rule;
  EXPECT_EQ(seamTurns(mesh, seams, rule).explained[v], portable::asin(0.5e-3));
  EXPECT_EQ(seamTurns(mesh, seams, rule).rounding[v], 0.0);
  rule.rounding = 4e-3;
  EXPECT_EQ(seamTurns(mesh, seams, rule).rounding[v], portable::asin(2e-3));
  seams.seams[0].isExplained = false;  // what is not explained excuses nothing
  EXPECT_EQ(seamTurns(mesh, seams, rule).explained[v], 0.0);
}

TEST(Angles, HoldAcrossHundredsOfDecades) {
  // Spokes of length 1 and 1e−200 in turn: squares underflow, angles do not.
  const Fan f = quarterFan(4);
  UvMap map = f.map;
  for (Vec2& p : map.uv) p[1] *= 1e-200;
  HolonomySpec spec = regular(4);
  const Certificate flat = certify(f.mesh, spec, map);
  EXPECT_CERTIFIED(flat);
  // A tiny piece beside an ordinary one.
  MeshData data{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}},
                {{0, 1, 2}, {3, 4, 5}}};
  map.uv = {{0, 0}, {1e-170, 0}, {0, 1e-170}, {5, 0}, {6, 0}, {5, 1}};
  map.cornerUv = data.triangles;
  spec.turning = {4, 4};
  const Certificate c = certify(test::meshOf(data), spec, map);
  EXPECT_NEAR(c.angles.smallestAngle, kPi / 4, 1e-15);
  // As asked, but no double can compare such areas: not usable, and so not certified.
  EXPECT_FALSE(c.isUsable);
  EXPECT_FALSE(c.isCertified);
  EXPECT_EQ(onlyReason(c).rule, Rule::kRange) << text(c);
  EXPECT_EQ(onlyReason(c).where[0].id, 0);
}

TEST(Verdict, GaussBonnetAndEulerAreCheckedInIntegers) {
  Certificate facts;
  facts.componentCount = 1;
  facts.eulerCharacteristic = 2;
  facts.gaussBonnetHave = facts.gaussBonnetNeed = 8;
  EXPECT_TRUE(findReasons(TriMesh{}, facts, CornerUv(), {}, {}).empty());
  facts.gaussBonnetHave = 7;
  facts.eulerCharacteristic = 1;
  const std::vector<Reason> reasons = findReasons(TriMesh{}, facts, CornerUv(), {}, {});
  ASSERT_EQ(reasons.size(), 2u);
  EXPECT_EQ(reasons[0].rule, Rule::kGaussBonnet);
  EXPECT_EQ(reasons[0].worst, -1);
  EXPECT_EQ(reasons[1].rule, Rule::kEuler);
}

TEST(Certificate, CountsOverlappingBoundaryVerticesWithoutRefusingThem) {
  // Five quarter turns around a boundary vertex.
  MeshData data;
  std::vector<Vec2> corners;
  data.positions.push_back({0, 0, 0});
  for (int i = 0; i <= 5; ++i) data.positions.push_back({std::cos(i), std::sin(i), double(i)});
  for (int i = 0; i < 5; ++i) {
    data.triangles.push_back({0, 1 + i, 2 + i});
    const Complex a = rotation(i, 4), b = rotation(i + 1, 4);
    corners.insert(corners.end(), {{0, 0}, {a.real(), a.imag()}, {b.real(), b.imag()}});
  }
  const TriMesh mesh = test::meshOf(data);
  HolonomySpec spec = regular(4);
  spec.turning = {4};
  const Certificate c = certify(mesh, spec, test::mapOfCorners(mesh, corners));
  EXPECT_CERTIFIED(c);
  EXPECT_EQ(c.angles.overlapping, std::vector<VertexId>{VertexId(0)});
}

// ---- what cannot be verified ----------------------------------------------------------------------

TEST(Certificate, MalformedMapsAreAFactNotACrash) {
  const TriMesh mesh = test::disk(2).mesh();
  const UvMap good = planarMap(mesh);
  UvMap map = good;
  map.cornerUv.pop_back();
  EXPECT_EQ(onlyReason(certify(mesh, regular(4), map)).rule, Rule::kMalformedUv);
  for (int n : {-1, static_cast<int>(good.uv.size()), 1000000, -2147483647 - 1}) {
    map = good;
    map.cornerUv[3][1] = n;
    const Certificate c = certify(mesh, regular(4), map);
    EXPECT_EQ(onlyReason(c).rule, Rule::kMalformedUv);
    EXPECT_EQ(c.reasons[0].where[0].id, 3);
    EXPECT_FALSE(c.isMeasured);
  }
  for (double x : {HUGE_VAL, -HUGE_VAL, std::nan("")}) {
    map = good;
    map.uv[static_cast<std::size_t>(map.cornerUv[5][2])][1] = x;
    const Certificate c = certify(mesh, regular(4), map);
    EXPECT_EQ(onlyReason(c).rule, Rule::kNotFinite);
    EXPECT_FALSE(c.isCertified);
  }
  map = good;
  map.uv.push_back({std::nan(""), 0});  // not used by any corner
  EXPECT_CERTIFIED(certify(mesh, regular(4), map));
  EXPECT_FALSE(certify(mesh, regular(4), UvMap{}).isCertified);
}

TEST(Certificate, PrescriptionsThatDoNotFitAreNamedAsReasons) {
  const TriMesh mesh = test::disk(2).mesh();
  const UvMap map = planarMap(mesh);
  HolonomySpec spec = regular(0);
  EXPECT_EQ(onlyReason(certify(mesh, spec, map)).rule, Rule::kPrescription);
  for (int v : {-1, 999999, mesh.vertexCount() - 1}) {  // the last vertex is on the boundary
    spec = regular(4);
    spec.cones = {{VertexId(v), 4}};
    EXPECT_EQ(onlyReason(certify(mesh, spec, map)).rule, Rule::kPrescription);
  }
  spec = regular(4);
  spec.cones = {{VertexId(0), 4}, {VertexId(0), 4}};
  EXPECT_EQ(onlyReason(certify(mesh, spec, map)).rule, Rule::kPrescription);
  spec = regular(4);
  spec.turning = {4, 4};
  EXPECT_EQ(onlyReason(certify(mesh, spec, map)).rule, Rule::kPrescription);
  spec = regular(4);
  spec.handles = {0};
  EXPECT_EQ(onlyReason(certify(mesh, spec, map)).rule, Rule::kPrescription);
}

TEST(Certificate, AnEmptyMeshIsNotCertified) {
  const Certificate c = certify(TriMesh{}, regular(4), UvMap{});
  EXPECT_EQ(onlyReason(c).rule, Rule::kEmpty);
  EXPECT_FALSE(c.isCertified);
  EXPECT_FALSE(areCertified({}));
  EXPECT_FALSE(areCertified({c}));
}

TEST(Certificate, SeveralComponentsAreVerifiedTogetherWithoutHandles) {
  const test::Shape a = test::disk(2), b = test::grid(2, 2);
  MeshData data = a.data;
  const int shift = static_cast<int>(data.positions.size());
  for (Vec3 p : b.data.positions) data.positions.push_back({p[0] + 5, p[1], p[2]});
  for (auto t : b.data.triangles)
    data.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  const TriMesh mesh = test::meshOf(data);
  HolonomySpec spec = regular(4);
  spec.turning = {4, 4};
  const Certificate c = certify(mesh, spec, planarMap(mesh));
  EXPECT_CERTIFIED(c);
  EXPECT_EQ(c.componentCount, 2);
  EXPECT_EQ(c.gaussBonnetHave, 8);
}

TEST(Certificate, ReasonsNameAsManyPlacesAsAskedWorstFirst) {
  const TriMesh mesh = test::disk(4).mesh();
  UvMap map = planarMap(mesh);
  for (Vec2& p : map.uv) p[0] = -p[0];
  CertifyOptions options;
  options.placesPerReason = 7;
  const Certificate c = certify(mesh, regular(4), map, options);
  EXPECT_EQ(c.orientation.negative, mesh.faceCount());
  EXPECT_EQ(c.reasons[0].rule, Rule::kOrientation);
  EXPECT_EQ(c.reasons[0].where.size(), 7u);
  EXPECT_EQ(c.reasons[0].count, mesh.faceCount());
}

TEST(Certificate, ALineAboutHandlesCountsAllAndNamesTheFirst) {
  const TriMesh mesh = test::torus(5, 4).mesh();
  HolonomySpec spec;
  spec.q = 4;
  spec.handles = {1, 2};
  const Certificate certificate = certify(mesh, spec, test::flatTorusMap(5, 4));
  EXPECT_FALSE(certificate.isCertified);
  int lines = 0;
  for (const Reason& reason : certificate.reasons) {
    if (reason.rule != Rule::kHandle) continue;
    ++lines;
    EXPECT_EQ(reason.count, 2);
    EXPECT_NE(reason.message.find("first is handle 0: measured 0, asked 1"), std::string::npos)
        << reason.message;
    for (const Where& place : reason.where) EXPECT_EQ(place.kind, Where::Kind::kEdge);
    EXPECT_FALSE(reason.where.empty());
  }
  EXPECT_EQ(lines, 1);
}

}  // namespace
}  // namespace hgp
