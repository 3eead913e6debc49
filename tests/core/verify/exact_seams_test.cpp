// Seams verified without tolerance.  Laws: a map of integers is exact; one ulp anywhere is seen; a
// quarter turn of a torus' side is not a broken seam.
#include "hgp/verify/exact_seams.h"

#include <gtest/gtest.h>

#include <cmath>

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

TEST(ExactSeams, OtherOrdersHaveNoExactCoordinates) {
  const TriMesh mesh = test::torus(5, 4).mesh();
  const UvMap map = test::flatTorusMap(5, 4);
  for (int q : {3, 5, 6}) EXPECT_FALSE(factsOf(mesh, map, q).isApplicable);
  for (int q : {1, 2, 4}) EXPECT_TRUE(factsOf(mesh, map, q).isApplicable);
}

}  // namespace
}  // namespace hgp
