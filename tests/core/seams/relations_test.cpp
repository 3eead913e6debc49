// Relations between translations and their solutions.  Laws: solved variables fulfil every relation, exactly; as many
// stay free as the rank leaves; on a lattice, every solution comes from exactly one y.
#include "hgp/seams/relations.h"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <random>

namespace hgp {
namespace {

template <class Ring>
Ring evaluate(const RingSum<Ring>& sum, const std::vector<Ring>& values) {
  Ring total{};
  for (const RingTerm<Ring>& t : sum) total = total + t.factor * values[at(t.variable)];
  return total;
}

template <class Ring>
std::vector<Ring> solution(const LatticeBasis<Ring>& basis, const std::vector<Ring>& y) {
  std::vector<Ring> t;
  for (const RingSum<Ring>& sum : basis.value) t.push_back(evaluate(sum, y));
  return t;
}

template <class Ring>
std::vector<RingSum<Ring>> randomRelations(std::mt19937& random, int variables, int count,
                                           int order) {
  std::vector<RingSum<Ring>> relations(at(count));
  for (RingSum<Ring>& sum : relations)
    for (unsigned n = 1 + random() % 4; n > 0; --n) {
      const Ring turn = Ring::turned(random() % 100, order);
      sum.push_back({static_cast<int>(random() % static_cast<unsigned>(variables)),
                     random() % 2 ? turn : -turn});
    }
  return relations;
}

/// The rank of the relations as complex numbers.
template <class Ring>
int rankOf(const std::vector<RingSum<Ring>>& relations, int variables) {
  Eigen::MatrixXcd A =
      Eigen::MatrixXcd::Zero(static_cast<Eigen::Index>(relations.size()), variables);
  for (std::size_t r = 0; r < relations.size(); ++r)
    for (const RingTerm<Ring>& t : relations[r])
      A(static_cast<Eigen::Index>(r), t.variable) += toComplex(t.factor);
  if (A.rows() == 0) return 0;
  Eigen::ColPivHouseholderQR<Eigen::MatrixXcd> qr(A);
  qr.setThreshold(1e-9);
  return static_cast<int>(qr.rank());
}

template <class Ring>
void expectSolved(const std::vector<RingSum<Ring>>& relations, int variables) {
  const FreeVariables<Ring> solved = eliminateRelations(variables, relations);
  int free = 0;
  for (const char isFree : solved.isFree) free += isFree;
  EXPECT_EQ(free, variables - rankOf(relations, variables));
  // Every relation, in terms of the free variables over the product of all denominators, vanishes.
  for (const RingSum<Ring>& relation : relations) {
    std::vector<Complex> total(at(variables), 0.0);
    for (const RingTerm<Ring>& t : relation) {
      const auto& value = solved.value[at(t.variable)];
      if (solved.isFree[at(t.variable)]) total[at(t.variable)] += toComplex(t.factor);
      for (const RingTerm<Ring>& f : value.sum) {
        EXPECT_TRUE(solved.isFree[at(f.variable)]);
        const Complex below = value.denominator ? toComplex(*value.denominator) : Complex(1.0);
        total[at(f.variable)] += toComplex(t.factor * f.factor) / below;
      }
    }
    for (const Complex& sum : total) EXPECT_LT(std::abs(sum), 1e-10);
  }
}

TEST(Relations, SolvedVariablesFulfilEveryRelationForEveryOrder) {
  std::mt19937 random(47);
  for (int round = 0; round < 300; ++round) {
    const int n = 1 + static_cast<int>(random() % 12), m = static_cast<int>(random() % at(n + 1));
    expectSolved(randomRelations<Gaussian>(random, n, m, 4), n);
    expectSolved(randomRelations<Eisenstein>(random, n, m, 6), n);
    const int q = 1 + static_cast<int>(random() % 12);
    expectSolved(randomRelations<Cyclotomic>(random, n, std::min(m, 4), q), n);
  }
}

TEST(Relations, OnesThatDifferByATurnTakeFreedomAwayOnce) {
  const RingSum<Eisenstein> relation{
      {0, {1, 0}}, {1, Eisenstein::turned(2)}, {2, Eisenstein::turned(3)}};
  RingSum<Eisenstein> turned = relation;
  for (auto& term : turned) term.factor = term.factor * Eisenstein::turned(4);
  const auto solved = eliminateRelations<Eisenstein>(3, {relation, turned, relation});
  EXPECT_EQ(solved.isFree[0] + solved.isFree[1] + solved.isFree[2], 2);
}

TEST(Relations, WithoutAnyAllVariablesAreFree) {
  const auto solved = eliminateRelations<Gaussian>(4, {});
  EXPECT_EQ(solved.isFree, (std::vector<char>{1, 1, 1, 1}));
}

TEST(Relations, BothEliminationsLeaveTheSameFreedom) {
  std::mt19937 random(13);
  for (int round = 0; round < 300; ++round) {
    const int n = 1 + static_cast<int>(random() % 9), m = static_cast<int>(random() % 6);
    const auto relations = randomRelations<Eisenstein>(random, n, m, 6);
    const auto solved = eliminateRelations(n, relations);
    const auto basis = solveRelations(n, relations);
    ASSERT_TRUE(basis);
    EXPECT_EQ(basis->size(), std::count(solved.isFree.begin(), solved.isFree.end(), 1));
  }
}

template <class Ring>
void expectOneCoordinateVector(std::mt19937& random, const std::vector<Ring>& factors) {
  for (int trial = 0; trial < 400; ++trial) {
    const int n = 3 + trial % 9, m = 1 + trial % 5;
    std::vector<RingSum<Ring>> relations(at(m));
    for (RingSum<Ring>& sum : relations)
      for (int v = 0; v < n; ++v)
        if (random() % 2 == 0) sum.push_back({v, factors[random() % factors.size()]});
    const auto basis = solveRelations(n, relations);
    ASSERT_TRUE(basis);
    EXPECT_GE(basis->size(), n - m);
    std::vector<Ring> y;
    for (int j = 0; j < basis->size(); ++j)
      y.push_back({static_cast<int>(random() % 9) - 4, static_cast<int>(random() % 9) - 4});
    const std::vector<Ring> t = solution(*basis, y);
    for (const RingSum<Ring>& sum : relations) EXPECT_TRUE(isZero(evaluate(sum, t)));
    for (int j = 0; j < basis->size(); ++j)
      EXPECT_EQ(evaluate(basis->coordinate[at(j)], t), y[at(j)]);
  }
}

TEST(LatticeRelations, EverySolutionHasExactlyOneCoordinateVector) {
  std::mt19937 random(11);
  expectOneCoordinateVector<Gaussian>(
      random, {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {1, -1}, {2, 0}, {3, 0}});
  expectOneCoordinateVector<Eisenstein>(
      random, {{1, 0}, {0, 1}, {-1, 0}, {1, 1}, {1, -1}, {2, 0}, {2, 1}, {3, 0}});
}

TEST(LatticeRelations, SolutionsWithoutUnitsAreAllFound) {
  // 2a + 3b = 0 has the solutions (3, −2) y, and no coefficient is a unit.
  const auto basis = solveRelations<Gaussian>(2, {{{0, {2, 0}}, {1, {3, 0}}}});
  ASSERT_TRUE(basis);
  ASSERT_EQ(basis->size(), 1);
  const std::vector<Gaussian> t = solution(*basis, {{1, 0}});
  EXPECT_EQ(norm(t[0]), 9);
  EXPECT_EQ(norm(t[1]), 4);
  EXPECT_TRUE(isZero(Gaussian{2, 0} * t[0] + Gaussian{3, 0} * t[1]));
}

TEST(LatticeRelations, RedundantOnesAreDropped) {
  const GaussianSum sum{{0, {1, 0}}, {1, {0, 1}}};
  const auto basis = solveRelations<Gaussian>(3, {sum, sum, {}});
  ASSERT_TRUE(basis);
  EXPECT_EQ(basis->size(), 2);
}

}  // namespace
}  // namespace hgp
