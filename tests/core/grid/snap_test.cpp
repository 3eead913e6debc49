// Maps rounded to a dyadic grid.  Laws: every seam holds exactly, in doubles and in floats, for every
// q that allows it; the map moves by a few steps at most; nothing turns over.
#include "hgp/grid/snap.h"

#include <gtest/gtest.h>

#include <cmath>

#include "hgp/parametrize/parametrize.h"
#include "support/maps.h"

namespace hgp {
namespace {

struct Solved {
  TriMesh mesh;
  Parametrization run;
  std::vector<VertexId> cones;
};

Solved solve(const test::Shape& shape, int q) {
  Solved s{shape.mesh(), {}, {}};
  SuggestOptions suggest;
  suggest.q = q;
  Result<CompleteSpec> spec = suggestCones(s.mesh, suggest);
  EXPECT_TRUE(spec) << shape.name << ": " << (spec ? "" : spec.error().message);
  if (!spec) return s;
  Result<Parametrization> run = parametrize(s.mesh, toSpec(*spec), {});
  EXPECT_TRUE(run) << shape.name;
  if (run) s.run = std::move(*run);
  EXPECT_TRUE(s.run.isCertified) << shape.name << " q = " << q;
  for (const ConePoint& cone : s.run.spec.cones) s.cones.push_back(cone.vertex);
  return s;
}

/// Checks the law with its own arithmetic: all numbers are multiples of 2^exponent, so integers say it.
void expectExact(const Solved& s, const std::vector<Vec2>& uv, int exponent, int q,
                 const std::string& name) {
  std::vector<Gaussian> p;
  for (const Vec2& z : uv) {
    const double u = std::ldexp(z[0], -exponent), v = std::ldexp(z[1], -exponent);
    ASSERT_EQ(u, std::rint(u)) << name;
    ASSERT_EQ(v, std::rint(v)) << name;
    p.push_back({std::llround(u), std::llround(v)});
  }
  const auto corner = [&](HalfedgeId h) {
    return p[at(s.run.map.cornerUv[at(h.i / 3)][at(h.i % 3)])];
  };
  int seams = 0;
  for (EdgeId e : s.mesh.edges()) {
    const HalfedgeId h = s.mesh.halfedge(e), twin = s.mesh.twin(h);
    if (!twin.isValid()) continue;
    const Gaussian a = corner(TriMesh::next(h)) - corner(h);
    const Gaussian b = corner(twin) - corner(TriMesh::next(twin));
    bool isTurned = false;
    for (int r = 0; r < 4; r += 4 / q) isTurned = isTurned || quarterTurn(r) * a == b;
    EXPECT_TRUE(isTurned) << name << " edge " << e.i;
    seams += corner(h) != corner(TriMesh::next(twin));
  }
  EXPECT_GT(seams + s.mesh.isBoundary(s.mesh.outgoing(VertexId(0))), 0) << name;
}

const std::vector<test::Shape>& shapes() {
  static const std::vector<test::Shape> list{test::jittered(test::icosphere(6), 0.02),
                                             test::jittered(test::pretzel(3, 2), 0.05),
                                             test::jittered(test::puncturedTorus(12, 9), 0.02),
                                             test::jittered(test::annulus(12, 4), 0.02)};
  return list;
}

TEST(SeamSnapper, SeamsAreExactInDoublesAndFloats) {
  for (const test::Shape& shape : shapes())
    for (int q : {2, 4}) {
      const Solved s = solve(shape, q);
      const auto snapper = SeamSnapper::make(s.mesh, s.run.map, q, s.cones);
      ASSERT_TRUE(snapper) << shape.name;
      for (const StoredNumbers& numbers : {StoredNumbers{53, false}, StoredNumbers{24, true}}) {
        const int exponent = gridExponent(s.run.map.uv, numbers);
        auto snapped = snapper->snap(s.run.map.uv, exponent, numbers);
        int used = exponent;
        if (!snapped) snapped = snapper->snap(s.run.map.uv, ++used, numbers);
        ASSERT_TRUE(snapped) << shape.name;
        EXPECT_TRUE(snapped->notPositive.empty()) << shape.name;
        expectExact(s, snapped->uv, used, q, shape.name);
        for (std::size_t c = 0; c < snapped->uv.size(); ++c)
          for (std::size_t k = 0; k < 2; ++k) {
            const double x = snapped->uv[c][k];
            EXPECT_NEAR(x, s.run.map.uv[c][k], std::ldexp(40.0, used)) << shape.name;
            if (!numbers.holdsFlipped) continue;
            EXPECT_EQ(x, static_cast<double>(static_cast<float>(x)));
            if (k == 1) {
              EXPECT_EQ(1.0 - static_cast<double>(static_cast<float>(1.0 - x)), x);
            }
          }
      }
    }
}

TEST(SeamSnapper, IntegerTranslationsStayWhatTheyAre) {
  // The square torus 5 × 4 has integer translations; a third of a step beside each vertex does not
  // change them.
  const TriMesh mesh = test::torus(5, 4).mesh();
  UvMap map = test::flatTorusMap(5, 4);
  const auto snapper = SeamSnapper::make(mesh, map, 4, {});
  ASSERT_TRUE(snapper);
  const auto snapped = snapper->snap(map.uv, -20, {});
  ASSERT_TRUE(snapped);
  EXPECT_EQ(snapped->uv, map.uv);
}

TEST(SeamSnapper, NumbersWhoseFlippedOnesAreNotExactAreRefused) {
  // v from −3/4 to 0: 24 bits hold v in steps of 2⁻²⁴, but 1 − v only in steps of 2⁻²³.
  const TriMesh mesh = test::torus(5, 4).mesh();
  UvMap map = test::flatTorusMap(5, 4);
  for (Vec2& p : map.uv) p = {0.15 * p[0], 0.15 * p[1] - 0.75};
  const auto snapper = SeamSnapper::make(mesh, map, 4, {});
  ASSERT_TRUE(snapper);
  EXPECT_EQ(gridExponent(map.uv, {24, false}), -24);
  EXPECT_EQ(gridExponent(map.uv, {24, true}), -23);
  EXPECT_TRUE(snapper->snap(map.uv, -24, {24, false}));
  EXPECT_FALSE(snapper->snap(map.uv, -24, {24, true}));
  EXPECT_TRUE(snapper->snap(map.uv, -23, {24, true}));
}

TEST(SeamSnapper, TrianglesThatRoundingFlipsAreRepairedWithAllCopies) {
  // On a coarse grid several triangles collapse; moving all copies of a vertex repairs them and keeps
  // the seams.
  const Solved s = solve(shapes()[1], 4);
  const auto snapper = SeamSnapper::make(s.mesh, s.run.map, 4, s.cones);
  ASSERT_TRUE(snapper);
  int repaired = 0;
  for (int exponent = -8; exponent <= -2; ++exponent) {
    const auto snapped = snapper->snap(s.run.map.uv, exponent, {});
    ASSERT_TRUE(snapped);
    expectExact(s, snapped->uv, exponent, 4, "coarse");
    if (snapped->moved > 0 && snapped->notPositive.empty()) ++repaired;
  }
  EXPECT_GT(repaired, 0);
}

/// Points of 2^exponent Z[ω], read back from uv with the arithmetic of this test: u = a − b/2, v = b √3/2.
std::vector<Eisenstein> trianglePoints(const std::vector<Vec2>& uv, int exponent,
                                       const StoredNumbers& numbers) {
  std::vector<Eisenstein> points;
  for (const Vec2& z : uv) {
    double v = z[1];
    if (numbers.digits == 24) v = 1.0 - static_cast<double>(static_cast<float>(1.0 - v));
    const double halves = std::ldexp(z[0], 1 - exponent);
    const auto b = std::llround(std::ldexp(v, -exponent) * 2.0 / std::sqrt(3.0));
    const auto m = std::llround(halves);
    EXPECT_EQ(halves, std::rint(halves));
    EXPECT_EQ((m + b) % 2, 0);
    points.push_back({(m + b) / 2, b});
  }
  return points;
}

TEST(SeamSnapper, SeamsOfSixthsAreExactBetweenLatticePoints) {
  for (const test::Shape& shape : shapes())
    for (int q : {3, 6}) {
      const Solved s = solve(shape, q);
      const auto snapper = SeamSnapper::make(s.mesh, s.run.map, q, s.cones);
      ASSERT_TRUE(snapper) << shape.name;
      for (const StoredNumbers& numbers : {StoredNumbers{53, false}, StoredNumbers{24, true}}) {
        int exponent = snapper->firstExponent(s.run.map.uv, numbers);
        auto snapped = snapper->snap(s.run.map.uv, exponent, numbers);
        if (!snapped) snapped = snapper->snap(s.run.map.uv, ++exponent, numbers);
        ASSERT_TRUE(snapped) << shape.name;
        EXPECT_TRUE(snapped->notPositive.empty()) << shape.name;
        for (std::size_t c = 0; c < snapped->uv.size(); ++c)
          for (std::size_t k = 0; k < 2; ++k)
            EXPECT_NEAR(snapped->uv[c][k], s.run.map.uv[c][k], std::ldexp(80.0, exponent));
        const std::vector<Eisenstein> points = trianglePoints(snapped->uv, exponent, numbers);
        const auto corner = [&](HalfedgeId h) {
          return points[at(s.run.map.cornerUv[at(h.i / 3)][at(h.i % 3)])];
        };
        for (EdgeId e : s.mesh.edges()) {
          const HalfedgeId h = s.mesh.halfedge(e), twin = s.mesh.twin(h);
          if (!twin.isValid()) continue;
          const Eisenstein left = corner(TriMesh::next(h)) - corner(h);
          const Eisenstein right = corner(twin) - corner(TriMesh::next(twin));
          bool isTurned = false;
          for (int r = 0; r < 6; r += 6 / q)
            isTurned = isTurned || Eisenstein::turned(r) * left == right;
          EXPECT_TRUE(isTurned) << shape.name << " q = " << q << " edge " << e.i;
        }
      }
    }
}

TEST(SeamSnapper, OtherOrdersAndForeignCopiesAreLeftAlone) {
  const TriMesh mesh = test::torus(5, 4).mesh();
  UvMap map = test::flatTorusMap(5, 4);
  EXPECT_FALSE(SeamSnapper::make(mesh, map, 5, {}));
  EXPECT_FALSE(SeamSnapper::make(mesh, map, 8, {}));
  map.cornerUv[0][0] = map.cornerUv[0][1];
  EXPECT_FALSE(SeamSnapper::make(mesh, map, 4, {}));
  map.cornerUv[0][0] = -1;
  EXPECT_FALSE(SeamSnapper::make(mesh, map, 4, {}));
}

}  // namespace
}  // namespace hgp
