// Gaussian integers a + bi.  Role: rotations by quarter turns and integer translations, exactly.
#pragma once

#include <cstdint>

#include "hgp/base/ids.h"
#include "hgp/base/turns.h"

namespace hgp {

struct Gaussian {
  std::int64_t re = 0, im = 0;

  friend constexpr bool operator==(const Gaussian&, const Gaussian&) = default;
  friend constexpr Gaussian operator+(Gaussian a, Gaussian b) { return {a.re + b.re, a.im + b.im}; }
  friend constexpr Gaussian operator-(Gaussian a, Gaussian b) { return {a.re - b.re, a.im - b.im}; }
  friend constexpr Gaussian operator-(Gaussian a) { return {-a.re, -a.im}; }
  friend constexpr Gaussian operator*(Gaussian a, Gaussian b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
  }
};

constexpr Gaussian conjugate(Gaussian a) { return {a.re, -a.im}; }
/// |a|², 1 exactly for the units ±1, ±i.
constexpr std::int64_t norm(Gaussian a) { return a.re * a.re + a.im * a.im; }
constexpr bool isZero(Gaussian a) { return a.re == 0 && a.im == 0; }
constexpr bool isUnit(Gaussian a) { return norm(a) == 1; }

/// i^turn for any integer turn.
constexpr Gaussian quarterTurn(long long turn) {
  constexpr Gaussian units[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  return units[((turn % 4) + 4) % 4];
}

/// The Gaussian integer nearest to a / b: |a − b·result|² ≤ |b|²/2. @pre b ≠ 0
constexpr Gaussian nearestQuotient(Gaussian a, Gaussian b) {
  const Gaussian product = a * conjugate(b);
  const std::int64_t n = norm(b);
  const auto round = [n](std::int64_t x) {
    const std::int64_t twice = 2 * x + n;  // floor(x / n + 1/2)
    return twice >= 0 ? twice / (2 * n) : -((-twice + 2 * n - 1) / (2 * n));
  };
  return {round(product.re), round(product.im)};
}

/// a / b where b divides a.
constexpr Gaussian exactQuotient(Gaussian a, Gaussian b) { return nearestQuotient(a, b); }
constexpr bool divides(Gaussian b, Gaussian a) { return isZero(a - b * nearestQuotient(a, b)); }

/// Greatest common divisor by Euclid, up to a unit; 0 for two zeros.
constexpr Gaussian commonDivisor(Gaussian a, Gaussian b) {
  while (!isZero(b)) {
    const Gaussian rest = a - b * nearestQuotient(a, b);
    a = b;
    b = rest;
  }
  return a;
}

inline Complex toComplex(Gaussian a) {
  return {static_cast<double>(a.re), static_cast<double>(a.im)};
}

}  // namespace hgp
