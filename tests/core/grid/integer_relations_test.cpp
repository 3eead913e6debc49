// Relations over Z[i] and their integer solutions.  Laws: every solution comes from exactly one y.
#include "hgp/grid/integer_relations.h"

#include <gtest/gtest.h>

#include <random>

namespace hgp {
namespace {

Gaussian evaluate(const GaussianSum& sum, const std::vector<Gaussian>& values) {
  Gaussian total;
  for (const GaussianTerm& t : sum) total = total + t.factor * values[at(t.variable)];
  return total;
}

std::vector<Gaussian> solution(const IntegerBasis& basis, const std::vector<Gaussian>& y) {
  std::vector<Gaussian> t;
  for (const GaussianSum& sum : basis.value) t.push_back(evaluate(sum, y));
  return t;
}

TEST(Gaussian, QuotientsAreNearestAndDivisorsDivide) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> any(-40, 40);
  for (int n = 0; n < 5000; ++n) {
    const Gaussian a{any(random), any(random)}, b{any(random), any(random)};
    if (isZero(b)) continue;
    EXPECT_LE(2 * norm(a - b * nearestQuotient(a, b)), norm(b));
    EXPECT_TRUE(divides(b, a * b));
    EXPECT_EQ(exactQuotient(a * b, b), a);
    const Gaussian d = commonDivisor(a, b);
    EXPECT_TRUE(divides(d, a) && divides(d, b));
  }
  for (int r = -8; r < 8; ++r) EXPECT_EQ(quarterTurn(r) * quarterTurn(-r), (Gaussian{1, 0}));
}

TEST(IntegerRelations, EverySolutionHasExactlyOneCoordinateVector) {
  std::mt19937 random(11);
  const Gaussian units[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {1, -1}, {2, 0}, {3, 0}};
  for (int trial = 0; trial < 400; ++trial) {
    const int n = 3 + trial % 9, m = 1 + trial % 5;
    std::vector<GaussianSum> relations(at(m));
    for (GaussianSum& sum : relations)
      for (int v = 0; v < n; ++v)
        if (random() % 2 == 0) sum.push_back({v, units[random() % 8]});
    const auto basis = solveRelations(n, relations);
    ASSERT_TRUE(basis);
    EXPECT_GE(basis->size(), n - m);
    std::vector<Gaussian> y;
    for (int j = 0; j < basis->size(); ++j)
      y.push_back({int(random() % 9) - 4, int(random() % 9) - 4});
    const std::vector<Gaussian> t = solution(*basis, y);
    for (const GaussianSum& sum : relations) EXPECT_TRUE(isZero(evaluate(sum, t)));
    for (int j = 0; j < basis->size(); ++j)
      EXPECT_EQ(evaluate(basis->coordinate[at(j)], t), y[at(j)]);
  }
}

TEST(IntegerRelations, SolutionsWithoutUnitsAreAllFound) {
  // 2a + 3b = 0 has the solutions (3, −2) y, and no coefficient is a unit.
  const auto basis = solveRelations(2, {{{0, {2, 0}}, {1, {3, 0}}}});
  ASSERT_TRUE(basis);
  ASSERT_EQ(basis->size(), 1);
  const std::vector<Gaussian> t = solution(*basis, {{1, 0}});
  EXPECT_EQ(norm(t[0]), 9);
  EXPECT_EQ(norm(t[1]), 4);
  EXPECT_TRUE(isZero(Gaussian{2, 0} * t[0] + Gaussian{3, 0} * t[1]));
}

TEST(IntegerRelations, RedundantRelationsAreDropped) {
  const GaussianSum sum{{0, {1, 0}}, {1, {0, 1}}};
  const auto basis = solveRelations(3, {sum, sum, {}});
  ASSERT_TRUE(basis);
  EXPECT_EQ(basis->size(), 2);
}

}  // namespace
}  // namespace hgp
