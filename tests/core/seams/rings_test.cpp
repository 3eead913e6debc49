// Z[i], Z[ω] and the cyclotomic rings.  Laws: they compute as complex numbers do, exactly; quotients leave a smaller
// remainder.
#include <gtest/gtest.h>

#include <random>

#include "hgp/seams/copy_place.h"

namespace hgp {
namespace {

template <class Ring>
Ring randomElement(std::mt19937& random) {
  return {static_cast<int>(random() % 81) - 40, static_cast<int>(random() % 81) - 40};
}

/// A sum of a few multiples of powers of ζ.
Cyclotomic randomSum(std::mt19937& random, int q) {
  Cyclotomic sum;
  for (unsigned n = random() % 4; n > 0; --n) {
    Cyclotomic power = Cyclotomic::turned(random() % 1000, q);
    if (random() % 2) power = -power;
    sum = sum + power;
  }
  return sum;
}

template <class Ring>
void expectHomomorphism(const Ring& a, const Ring& b) {
  const Complex x = toComplex(a), y = toComplex(b);
  const double size = 1e-13 * (1.0 + std::abs(x)) * (1.0 + std::abs(y));
  EXPECT_LT(std::abs(toComplex(a + b) - (x + y)), size);
  EXPECT_LT(std::abs(toComplex(a - b) - (x - y)), size);
  EXPECT_LT(std::abs(toComplex(a * b) - x * y), size);
  EXPECT_LT(std::abs(toComplex(conjugate(a)) - std::conj(x)), size);
}

template <class Ring>
void expectQuotients(const Ring& a, const Ring& b) {
  if (isZero(b)) return;
  EXPECT_LE(4 * norm(a - b * nearestQuotient(a, b)), 3 * norm(b));
  EXPECT_TRUE(divides(b, a * b));
  EXPECT_EQ(exactQuotient(a * b, b), a);
  const Ring d = commonDivisor(a, b);
  EXPECT_TRUE(divides(d, a) && divides(d, b));
  EXPECT_NEAR(static_cast<double>(norm(a)), std::norm(toComplex(a)), 1e-9);
}

TEST(Rings, ComputeAsComplexNumbersDo) {
  std::mt19937 random(3);
  for (int n = 0; n < 2000; ++n) {
    expectHomomorphism(randomElement<Gaussian>(random), randomElement<Gaussian>(random));
    expectHomomorphism(randomElement<Eisenstein>(random), randomElement<Eisenstein>(random));
    const int q = 1 + static_cast<int>(random() % 24);
    expectHomomorphism(randomSum(random, q), randomSum(random, q));
  }
}

TEST(Rings, QuotientsAreNearAndDivisorsDivide) {
  std::mt19937 random(7);
  for (int n = 0; n < 5000; ++n) {
    expectQuotients(randomElement<Gaussian>(random), randomElement<Gaussian>(random));
    expectQuotients(randomElement<Eisenstein>(random), randomElement<Eisenstein>(random));
  }
}

TEST(Rings, TurnsAreTheRotations) {
  for (int r = -13; r < 13; ++r) {
    EXPECT_EQ(toComplex(Gaussian::turned(r)), rotation(r, 4));
    EXPECT_LT(std::abs(toComplex(Eisenstein::turned(r)) - rotation(r, 6)), 1e-15);
    EXPECT_TRUE(isUnit(Gaussian::turned(r)) && isUnit(Eisenstein::turned(r)));
    EXPECT_EQ(Gaussian::turned(r) * Gaussian::turned(-r), (Gaussian{1, 0}));
    EXPECT_EQ(Eisenstein::turned(r) * Eisenstein::turned(-r), (Eisenstein{1, 0}));
    for (int q = 1; q <= 64; ++q) {
      const Cyclotomic turn = Cyclotomic::turned(r, q);
      EXPECT_TRUE(isUnit(turn));
      EXPECT_LT(std::abs(toComplex(turn) - rotation(r, q)), 1e-15);
      EXPECT_EQ(turn * conjugate(turn), Cyclotomic::turned(0, q));
    }
  }
}

TEST(Rings, CyclotomicSumsAreZeroExactlyWhereTheNumberIs) {
  // Sums over all p-th roots of unity vanish for every prime p that divides q; a sum of few powers, otherwise, does
  // not come close to 0.
  std::mt19937 random(5);
  int zero = 0;
  for (int q = 1; q <= 64; ++q) {
    for (int p = 2; p <= q; ++p) {
      if (q % p != 0) continue;
      Cyclotomic sum;
      for (int j = 0; j < p; ++j) sum = sum + Cyclotomic::turned(j * (q / p) + 3, q);
      EXPECT_TRUE(isZero(sum)) << q << " " << p;
      EXPECT_FALSE(isZero(sum + Cyclotomic::turned(1, q)));
      ++zero;
    }
    for (int n = 0; n < 200; ++n) {
      const Cyclotomic a = randomSum(random, q) * randomSum(random, q);
      EXPECT_EQ(isZero(a), std::abs(toComplex(a)) < 1e-9) << q;
    }
  }
  EXPECT_GT(zero, 100);
}

}  // namespace
}  // namespace hgp
