// Division with remainder in a ring of integers of the plane.  Role: shared by Z[i] and Z[ω], whose nearest quotients
// leave a smaller remainder.
#pragma once

#include <cstdint>

namespace hgp {

/// ⌊x/n + 1/2⌋. @pre n > 0
constexpr std::int64_t roundedQuotient(std::int64_t x, std::int64_t n) {
  const std::int64_t twice = 2 * x + n;
  return twice >= 0 ? twice / (2 * n) : -((-twice + 2 * n - 1) / (2 * n));
}

/// a / b where b divides a.
template <class Ring>
constexpr Ring exactQuotient(Ring a, Ring b) {
  return nearestQuotient(a, b);
}

template <class Ring>
constexpr bool divides(Ring b, Ring a) {
  return isZero(a - b * nearestQuotient(a, b));
}

/// Greatest common divisor by Euclid, up to a unit; 0 for two zeros.
template <class Ring>
constexpr Ring commonDivisor(Ring a, Ring b) {
  while (!isZero(b)) {
    const Ring rest = a - b * nearestQuotient(a, b);
    a = b;
    b = rest;
  }
  return a;
}

}  // namespace hgp
