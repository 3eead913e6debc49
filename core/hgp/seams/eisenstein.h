// Eisenstein integers a + bω, ω = e^{i2π/3}.  Role: rotations by sixths of a turn and translations on a triangular
// lattice, exactly: q = 3, 6.
#pragma once

#include <cstdint>

#include "hgp/base/turns.h"
#include "hgp/seams/euclid.h"

namespace hgp {

struct Eisenstein {
  static constexpr bool kIsEuclidean = true;
  static constexpr int kOrder = 6;  ///< of the rotations it contains: e^{i2πr/6} = (1 + ω)^r
  std::int64_t a = 0, b = 0;

  /// e^{i2πr/6} for any integer r; `order` is kOrder.
  static constexpr Eisenstein turned(long long r, int /*order*/ = kOrder) {
    constexpr int kA[] = {1, 1, 0, -1, -1, 0}, kB[] = {0, 1, 1, 0, -1, -1};
    const auto n = static_cast<std::size_t>(reduceTurn(r, kOrder));
    return {kA[n], kB[n]};
  }

  friend constexpr bool operator==(const Eisenstein&, const Eisenstein&) = default;
  friend constexpr Eisenstein operator+(Eisenstein x, Eisenstein y) {
    return {x.a + y.a, x.b + y.b};
  }
  friend constexpr Eisenstein operator-(Eisenstein x, Eisenstein y) {
    return {x.a - y.a, x.b - y.b};
  }
  friend constexpr Eisenstein operator-(Eisenstein x) { return {-x.a, -x.b}; }
  /// ω² = −1 − ω
  friend constexpr Eisenstein operator*(Eisenstein x, Eisenstein y) {
    return {x.a * y.a - x.b * y.b, x.a * y.b + x.b * y.a - x.b * y.b};
  }
};

/// a + bω̄, ω̄ = −1 − ω
constexpr Eisenstein conjugate(Eisenstein x) { return {x.a - x.b, -x.b}; }
/// |x|², 1 exactly for the six units.
constexpr std::int64_t norm(Eisenstein x) { return x.a * x.a - x.a * x.b + x.b * x.b; }
constexpr bool isZero(Eisenstein x) { return x.a == 0 && x.b == 0; }
constexpr bool isUnit(Eisenstein x) { return norm(x) == 1; }

/// x / y with both lattice coordinates rounded: |x − y·result|² ≤ ¾|y|². @pre y ≠ 0
constexpr Eisenstein nearestQuotient(Eisenstein x, Eisenstein y) {
  const Eisenstein product = x * conjugate(y);
  return {roundedQuotient(product.a, norm(y)), roundedQuotient(product.b, norm(y))};
}

inline Complex toComplex(Eisenstein x) {
  constexpr double kHalfRootOf3 = 0.5 * std::numbers::sqrt3;
  return {0.5 * static_cast<double>(2 * x.a - x.b), kHalfRootOf3 * static_cast<double>(x.b)};
}

}  // namespace hgp
