// Integers near the minimiser of a form.  Laws: rounding and reduction keep every integer in reach; what must stay
// apart does; the form decides between choices that do.
#include "hgp/grid/integer_choice.h"

#include <gtest/gtest.h>

#include <random>

namespace hgp {
namespace {

Eigen::VectorXcd vectorOf(double a, double b) {
  Eigen::VectorXcd out = Eigen::VectorXcd::Zero(2);
  out[0] = a;
  out[1] = b;
  return out;
}

Eigen::MatrixXcd formOf(double diagonal, double beside) {
  Eigen::MatrixXcd out = Eigen::MatrixXcd::Constant(2, 2, beside);
  out.diagonal().setConstant(diagonal);
  return out;
}

TEST(IntegerChoice, TwoUnknownsThatMustStayApartStayApart) {
  // Both want to be near 0.3; rounded alone they meet.
  const Eigen::MatrixXcd S = formOf(1.0, 0.0);
  const Eigen::VectorXcd y0 = vectorOf(0.1, 0.45);
  const auto form = std::make_shared<const IntegerForm>(S);
  const IntegerChoice alone(form, {});
  EXPECT_EQ(alone.near(y0)[0], alone.near(y0)[1]);
  const IntegerChoice apart(form, {{{{0, Complex(-1.0)}, {1, Complex(1.0)}}}});
  const std::vector<Gaussian> y = apart.near(y0);
  EXPECT_EQ(y[0], (Gaussian{0, 0}));
  EXPECT_EQ(y[1], (Gaussian{1, 0}));
  EXPECT_EQ(apart.wrongSeparations(y0, y), 0);
  EXPECT_EQ(apart.wrongSeparations(y0, alone.near(y0)), 1);
  EXPECT_EQ(apart.wrongPairs(y0, alone.near(y0)), 1);
}

TEST(IntegerChoice, ConditionalRoundingBeatsRoundingEachAlone) {
  // Strongly coupled: the sum wants to be 1, each wants to be 0.5.
  const Eigen::MatrixXcd S = formOf(101.0, 100.0);
  const Eigen::VectorXcd y0 = vectorOf(0.49, 0.49);
  const IntegerChoice choice(std::make_shared<const IntegerForm>(S), {});
  const std::vector<Gaussian> y = choice.near(y0);
  EXPECT_EQ(y[0].re + y[1].re, 1);
  EXPECT_LT(choice.energy(y0, y), choice.energy(y0, {{0, 0}, {0, 0}}));
}

/// Well conditioned, random, the same on every machine: AᴴA + I.
Eigen::MatrixXcd randomForm(int k, unsigned seed) {
  std::mt19937 draw(seed);
  const auto number = [&] { return static_cast<double>(draw() % 2001) / 1000.0 - 1.0; };
  Eigen::MatrixXcd A(k, k);
  for (int i = 0; i < k; ++i)
    for (int j = 0; j < k; ++j) A(i, j) = Complex(number(), number());
  return A.adjoint() * A + Eigen::MatrixXcd::Identity(k, k);
}

std::vector<Gaussian> randomIntegers(int k, unsigned seed) {
  std::mt19937 draw(seed);
  std::vector<Gaussian> y;
  for (int j = 0; j < k; ++j) {
    const auto re = static_cast<std::int64_t>(draw() % 41) - 20;
    y.push_back({re, static_cast<std::int64_t>(draw() % 41) - 20});
  }
  return y;
}

Eigen::VectorXcd toVector(const std::vector<Gaussian>& y) {
  Eigen::VectorXcd out(static_cast<Eigen::Index>(y.size()));
  for (std::size_t j = 0; j < y.size(); ++j) out[static_cast<Eigen::Index>(j)] = toComplex(y[j]);
  return out;
}

TEST(IntegerForm, TheReducedBasisHasTheSameIntegersAndTheSameValues) {
  for (unsigned seed : {1u, 2u, 3u}) {
    const int k = 12;
    // A basis that needs it: the second vector is the first a few times over, and a little.
    Eigen::MatrixXcd U = Eigen::MatrixXcd::Identity(k, k);
    for (int j = 1; j < k; ++j) U(j - 1, j) = Complex(3.0, -2.0);
    const Eigen::MatrixXcd S = U.adjoint() * randomForm(k, seed) * U;
    const IntegerForm form(S);
    EXPECT_LT(form.matrix().trace().real(), 0.5 * S.trace().real());
    const std::vector<Gaussian> y = randomIntegers(k, seed);
    const Eigen::VectorXcd w = form.toReduced(toVector(y));
    std::vector<Gaussian> integers;
    for (Eigen::Index j = 0; j < k; ++j) {
      EXPECT_EQ(w[j], Complex(std::rint(w[j].real()), std::rint(w[j].imag())));
      integers.push_back({std::llround(w[j].real()), std::llround(w[j].imag())});
    }
    EXPECT_EQ(form.toOriginal(integers), y);
    const double value = std::real(toVector(y).dot(S * toVector(y)));
    EXPECT_NEAR(std::real(w.dot(form.matrix() * w)), value, 1e-9 * value);

    IntegerForm::Terms linear, back;
    for (int j = 0; j < k; j += 3) linear.push_back({j, Complex(j, 1.0)});
    Complex before = 0.0, after = 0.0;
    for (const auto& [j, factor] : linear)
      before += factor * toComplex(y[static_cast<std::size_t>(j)]);
    for (const auto& [j, factor] : form.toReduced(linear)) after += factor * w[j];
    EXPECT_NEAR(std::abs(after - before), 0.0, 1e-9);
  }
}

TEST(IntegerForm, SolvesAndKeepsIntegersWhereTheyAre) {
  const int k = 15;
  const IntegerForm form(randomForm(k, 7));
  const Eigen::MatrixXcd G = randomForm(k, 8).leftCols(4);
  EXPECT_LT((form.matrix() * form.solve(G) - G).norm(), 1e-9 * G.norm());
  const std::vector<Gaussian> y = randomIntegers(k, 9);
  EXPECT_EQ(form.rounded(toVector(y)), y);
}

TEST(IntegerForm, RoundingMovesWhatIsNotRoundedYetToItsConditionalMinimum) {
  // In the mean over forms: the sum of the conditional variances, where rounding each alone gives the trace.
  double chosen = 0.0, alone = 0.0;
  std::mt19937 draw(5);
  for (unsigned seed = 1; seed <= 200; ++seed) {
    const int k = 10;
    const IntegerForm form(randomForm(k, seed));
    Eigen::VectorXcd w(k), nearest(k);
    for (Eigen::Index j = 0; j < k; ++j) {
      w[j] = {static_cast<double>(draw() % 10000) / 1e3, static_cast<double>(draw() % 10000) / 1e3};
      nearest[j] = {std::rint(w[j].real()), std::rint(w[j].imag())};
    }
    const Eigen::VectorXcd d = toVector(form.rounded(w)) - w, e = nearest - w;
    chosen += std::real(d.dot(form.matrix() * d));
    alone += std::real(e.dot(form.matrix() * e));
  }
  EXPECT_LT(chosen, 0.8 * alone);
}

TEST(IntegerChoice, ManyCloseConesAreSpreadTogether) {
  // Seven in a row within a third of a cell, each free to move: neighbours end one apart, in their order, and
  // the middle stays where it is.
  const int k = 7;
  std::vector<Separation> row;
  Eigen::VectorXcd y0(k);
  for (int j = 0; j < k; ++j) y0[j] = 0.05 * (j - 3);
  for (int j = 1; j < k; ++j) row.push_back({{{j - 1, Complex(-1.0)}, {j, Complex(1.0)}}});
  const auto form = std::make_shared<const IntegerForm>(Eigen::MatrixXcd::Identity(k, k));
  const IntegerChoice choice(form, row);
  const std::vector<Gaussian> y = choice.near(y0);
  for (int j = 0; j < k; ++j) EXPECT_EQ(y[static_cast<std::size_t>(j)], (Gaussian{j - 3, 0})) << j;
}

TEST(IntegerChoice, ThreeConesKeepTheirOrientation) {
  // A flat triangle whose nearest integers are the wrong way round.
  Separation turn;
  turn.terms = {{0, Complex(1.0)}};
  turn.second = {{1, Complex(1.0)}};
  const auto form = std::make_shared<const IntegerForm>(Eigen::MatrixXcd::Identity(2, 2));
  Eigen::VectorXcd y0(2);
  y0 << Complex(1.45, 0.55), Complex(2.55, 1.45);
  const std::vector<Gaussian> before = IntegerChoice(form, {}).near(y0);
  const IntegerChoice choice(form, {turn});
  EXPECT_EQ(choice.wrongSeparations(y0, before), 1);
  EXPECT_EQ(choice.wrongPairs(y0, before), 0);
  const std::vector<Gaussian> y = choice.near(y0);
  EXPECT_EQ(choice.wrongSeparations(y0, y), 0);
  EXPECT_GT((conjugate(y[0]) * y[1]).im, 0);
}

}  // namespace
}  // namespace hgp
