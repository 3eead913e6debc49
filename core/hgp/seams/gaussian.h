// Gaussian integers a + bi.  Role: rotations by quarter turns and integer translations, exactly: q = 1, 2, 4.
#pragma once

#include <cstdint>

#include "hgp/base/turns.h"
#include "hgp/seams/euclid.h"

namespace hgp {

struct Gaussian {
  static constexpr bool kIsEuclidean = true;
  static constexpr int kOrder = 4;  ///< of the rotations it contains: i^r
  std::int64_t re = 0, im = 0;

  /// i^r for any integer r; `order` is kOrder.
  static constexpr Gaussian turned(long long r, int /*order*/ = kOrder) {
    constexpr int kRe[] = {1, 0, -1, 0}, kIm[] = {0, 1, 0, -1};
    const auto n = static_cast<std::size_t>(reduceTurn(r, kOrder));
    return {kRe[n], kIm[n]};
  }

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
constexpr Gaussian quarterTurn(long long turn) { return Gaussian::turned(turn); }

/// The Gaussian integer nearest to a / b: |a − b·result|² ≤ |b|²/2. @pre b ≠ 0
constexpr Gaussian nearestQuotient(Gaussian a, Gaussian b) {
  const Gaussian product = a * conjugate(b);
  return {roundedQuotient(product.re, norm(b)), roundedQuotient(product.im, norm(b))};
}

inline Complex toComplex(Gaussian a) {
  return {static_cast<double>(a.re), static_cast<double>(a.im)};
}

}  // namespace hgp
