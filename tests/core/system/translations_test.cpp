#include "hgp/system/translations.h"

#include <gtest/gtest.h>

#include "support/prescriptions.h"

namespace hgp {
namespace {

Complex valueOf(const TranslationSum& sum, const std::vector<Complex>& t) {
  Complex value = 0.0;
  for (const TranslationTerm& term : sum)
    value += term.factor * t[static_cast<std::size_t>(term.chain)];
  return value;
}

/// Values of all translations when the free ones are random.
std::vector<Complex> extend(const std::vector<TranslationSum>& solved, std::mt19937& random) {
  std::vector<Complex> free(solved.size(), 0.0), all(solved.size());
  for (std::size_t c = 0; c < solved.size(); ++c)
    if (solved[c].size() == 1 && solved[c][0].chain == static_cast<int>(c))
      free[c] = {test::randomReal(random), test::randomReal(random)};
  for (std::size_t c = 0; c < solved.size(); ++c) all[c] = valueOf(solved[c], free);
  return all;
}

TEST(Translations, SolvedOnesFulfilEveryRelation) {
  std::mt19937 random(47);
  for (int round = 0; round < 200; ++round) {
    const int q = 1 + test::randomBelow(random, 8);
    const int chains = 1 + test::randomBelow(random, 12);
    std::vector<TranslationSum> relations;
    for (int r = test::randomBelow(random, chains + 1); r > 0; --r) {
      TranslationSum sum;
      for (int n = 1 + test::randomBelow(random, 4); n > 0; --n)
        sum.push_back({test::randomBelow(random, chains),
                       (n % 2 ? 1.0 : -1.0) * rotation(test::randomBelow(random, q), q)});
      relations.push_back(sum);
    }
    const std::vector<TranslationSum> solved = solveTranslations(chains, relations);
    ASSERT_EQ(static_cast<int>(solved.size()), chains);
    const std::vector<Complex> t = extend(solved, random);
    for (const TranslationSum& relation : relations)
      EXPECT_LT(std::abs(valueOf(relation, t)), 1e-10);
  }
}

TEST(Translations, RedundantRelationsTakeNoFreedomAway) {
  const TranslationSum relation{{0, 1.0}, {1, rotation(1, 3)}, {2, -1.0}};
  TranslationSum turned = relation;
  for (TranslationTerm& term : turned) term.factor *= rotation(2, 3);
  int free = 0;
  const auto solved = solveTranslations(3, {relation, turned, relation});
  for (std::size_t c = 0; c < 3; ++c)
    free += solved[c].size() == 1 && solved[c][0].chain == static_cast<int>(c);
  EXPECT_EQ(free, 2);
}

TEST(Translations, WithoutRelationsAreAllFree) {
  const auto solved = solveTranslations(4, {});
  for (int c = 0; c < 4; ++c) {
    ASSERT_EQ(solved[static_cast<std::size_t>(c)].size(), 1u);
    EXPECT_EQ(solved[static_cast<std::size_t>(c)][0].chain, c);
    EXPECT_EQ(solved[static_cast<std::size_t>(c)][0].factor, Complex(1.0));
  }
}

}  // namespace
}  // namespace hgp
