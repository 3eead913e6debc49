// Seams verified without tolerance.  Laws: a map of integers is exact; one ulp anywhere is seen; a
// quarter turn of a torus' side is not a broken seam.
#include "hgp/verify/exact_seams.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "hgp/verify/certificate.h"
#include "support/maps.h"

namespace hgp {
namespace {

ExactSeamFacts factsOf(const TriMesh& mesh, const UvMap& map, int q) {
  HolonomySpec asked;
  asked.q = q;
  CertifyOptions options;
  options.isAnyConeAllowed = true;
  return certify(mesh, asked, map, options).exactSeams;
}

TEST(ExactSeams, DevelopedCubesAreExactAndTheirTranslationsIntegers) {
  const TriMesh mesh = test::pretzel(1).mesh();
  const UvMap map = test::developedMap(mesh);
  const ExactSeamFacts facts = factsOf(mesh, map, 4);
  EXPECT_TRUE(facts.isApplicable);
  EXPECT_GT(facts.exact, 10);
  EXPECT_EQ(facts.integer, facts.exact);
  EXPECT_TRUE(facts.inexact.empty());
}

TEST(ExactSeams, DetectsOneUlpThatTolerancesAccept) {
  const TriMesh mesh = test::torus(5, 4).mesh();
  UvMap map = test::flatTorusMap(5, 4);
  const ExactSeamFacts before = factsOf(mesh, map, 4);
  EXPECT_TRUE(before.inexact.empty());
  // The corner (0, 0) has four copies, so that moving one tears four seam edges at most.
  map.uv[0][0] = std::nextafter(map.uv[0][0] + 1e-9, 1.0);
  const ExactSeamFacts after = factsOf(mesh, map, 4);
  EXPECT_GE(after.inexact.size(), 1u);
  EXPECT_LE(after.inexact.size(), 4u);
  EXPECT_EQ(after.exact + static_cast<int>(after.inexact.size()), before.exact);
}

TEST(ExactSeams, ExactSeamsNeedNotHaveIntegerTranslations) {
  const TriMesh mesh = test::torus(3, 3).mesh();
  UvMap map = test::flatTorusMap(3, 3);
  for (Vec2& p : map.uv) p = {p[0] * 0x1p-40, p[1] * 0x1p-40};
  const ExactSeamFacts small = factsOf(mesh, map, 4);
  EXPECT_TRUE(small.inexact.empty());
  EXPECT_EQ(small.integer, 0);
  EXPECT_GT(small.exact, 0);
}

TEST(ExactSeams, TranslationsThatAreEqualOnlyWhenRoundedAreInexact) {
  // One of the two copies of a vertex is moved by 2⁻⁶⁰: the translation at it rounds to the same double as before.
  const TriMesh mesh = test::torus(5, 4).mesh();
  UvMap map = test::flatTorusMap(5, 4);
  const ExactSeamFacts before = factsOf(mesh, map, 4);
  ASSERT_TRUE(before.inexact.empty());
  std::size_t tiny = map.uv.size();
  for (std::size_t i = 0; i < map.uv.size(); ++i)
    if (map.uv[i][0] == 0.0 && map.uv[i][1] > 0.0 && map.uv[i][1] < 4.0) tiny = i;
  ASSERT_LT(tiny, map.uv.size());
  map.uv[tiny][0] = 0x1p-60;  // a side at 0 and its other side at 5: 5 − 2⁻⁶⁰ is 5 when rounded
  const ExactSeamFacts after = factsOf(mesh, map, 4);
  EXPECT_EQ(after.inexact.size(), 2u);  // the two seam edges at this vertex
}

/// The torus of 5 × 4 parallelograms with corners a + bω, as it is stored in one of the formats.
UvMap triangularMap(double scale, const std::function<double(double)>& stored) {
  UvMap map = test::flatTorusMap(5, 4);
  for (Vec2& p : map.uv) {
    const double a = p[0], b = p[1];
    p = {scale * (a - 0.5 * b), stored(scale * (b * (0.5 * std::numbers::sqrt3)))};
  }
  return map;
}

TEST(ExactSeams, OfSixthsHoldBetweenThePointsOfATriangularLattice) {
  const TriMesh mesh = test::torus(5, 4).mesh();
  // As doubles and as float32 on a grid, on which 1 − v is exact as well.
  const std::vector<std::function<double(double)>> formats = {
      [](double v) { return v; }, [](double v) { return 0x1p-20 * std::nearbyint(0x1p20 * v); }};
  for (int q : {3, 6})
    for (const auto& stored : formats) {
      const ExactSeamFacts whole = factsOf(mesh, triangularMap(1.0, stored), q);
      EXPECT_TRUE(whole.isApplicable && whole.isTriangular);
      EXPECT_TRUE(whole.inexact.empty());
      EXPECT_EQ(whole.exact, 5 + 4);
      EXPECT_EQ(whole.integer, whole.exact);
      const ExactSeamFacts small = factsOf(mesh, triangularMap(0x1p-9, stored), q);
      EXPECT_TRUE(small.inexact.empty());
      EXPECT_EQ(small.integer, 0);
    }
}

TEST(ExactSeams, OneUlpBesideALatticePointIsNoPoint) {
  const TriMesh mesh = test::torus(5, 4).mesh();
  const auto asIs = [](double v) { return v; };
  UvMap off = triangularMap(1.0, asIs);
  off.uv[7][1] = std::nextafter(off.uv[7][1], 9.0);
  EXPECT_EQ(factsOf(mesh, off, 6).exact, 0);
  // A point of the lattice, but not where the other side of the seam has it.
  UvMap moved = triangularMap(1.0, asIs);
  const UvMap finer = triangularMap(0x1p-20, asIs);
  for (std::size_t k = 0; k < 2; ++k) moved.uv[0][k] += finer.uv[1][k] - finer.uv[0][k];
  const ExactSeamFacts facts = factsOf(mesh, moved, 6);
  EXPECT_GE(facts.inexact.size(), 1u);
  EXPECT_LE(facts.inexact.size(), 4u);
  EXPECT_EQ(facts.exact + static_cast<int>(facts.inexact.size()), 5 + 4);
}

TEST(ExactSeams, NumbersThatMayStandForTwoPointsAreNoneOfTheLattice) {
  // One vertex at b = 1 says how fine the lattice is. 4 · 2⁴⁸ rows up, doubles are a quarter of a step apart; 4 · 2⁵⁰ rows
  // up they are half a step apart, and two rows may become the same double.
  const TriMesh mesh = test::torus(5, 4).mesh();
  for (const double size : {0x1p48, 0x1p50}) {
    UvMap map = test::flatTorusMap(5, 4);
    bool isFirst = true;
    for (Vec2& p : map.uv) {
      const bool isInside = p[0] > 0.0 && p[0] < 5.0 && p[1] > 0.0 && p[1] < 4.0;
      const double a = p[0] * 0x1p48, b = isInside && isFirst ? 1.0 : p[1] * size;
      isFirst = isFirst && !isInside;
      p = {a - 0.5 * b, b * (0.5 * std::numbers::sqrt3)};
    }
    ASSERT_FALSE(isFirst);
    EXPECT_EQ(factsOf(mesh, map, 6).exact, size == 0x1p48 ? 5 + 4 : 0) << size;
  }
}

TEST(ExactSeams, MapsOnNoLatticeHaveNoExactSeamsOfSixths) {
  const TriMesh mesh = test::torus(5, 4).mesh();
  UvMap map = triangularMap(1.0, [](double v) { return v; });
  for (Vec2& p : map.uv) p[0] *= 1.0 / 3.0;
  EXPECT_EQ(factsOf(mesh, map, 3).exact, 0);
}

TEST(ExactSeams, OtherOrdersKeepNoLattice) {
  const TriMesh mesh = test::torus(5, 4).mesh();
  const UvMap map = test::flatTorusMap(5, 4);
  for (int q : {5, 7, 8, 12}) EXPECT_FALSE(factsOf(mesh, map, q).isApplicable);
  for (int q : {1, 2, 3, 4, 6}) EXPECT_TRUE(factsOf(mesh, map, q).isApplicable);
}

}  // namespace
}  // namespace hgp
