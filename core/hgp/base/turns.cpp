#include "hgp/base/turns.h"

#include <cmath>
#include <cstdlib>

#include "hgp/base/portable_math.h"

namespace hgp {

Complex rotation(long long r, int q) {
  // The nearest quarter turn is separated, so that the arguments of sin and cos are at most π/4 and
  // symmetric angles have exactly symmetric values.
  const long long n = reduceTurn(r, q);
  const long long quarters = (8 * n / q + 1) / 2;
  const long long rest = 4 * n - quarters * q;  // in units of 2π/4q, |rest| ≤ q/2
  double c = 1.0, s = 0.0;
  if (rest != 0) {
    const double angle = 2.0 * kPi * static_cast<double>(std::llabs(rest)) / (4.0 * q);
    const bool isEighth = 2 * std::llabs(rest) == q;
    c = isEighth ? std::numbers::sqrt2 / 2 : portable::cos(angle);
    s = (rest < 0 ? -1.0 : 1.0) * (isEighth ? c : portable::sin(angle));
  }
  switch (quarters % 4) {
    case 0:
      return {c, s};
    case 1:
      return {-s, c};
    case 2:
      return {-c, -s};
    default:
      return {s, -c};
  }
}

double principalAngle(double angle) {
  // Up to about 3π the remainder needs at most one subtraction, which is exact and ten times as fast as
  // std::remainder.
  constexpr double kOneTurnAtMost = 9.0;
  double a = angle;
  if (std::abs(angle) >= kOneTurnAtMost)
    a = std::remainder(angle, 2.0 * kPi);
  else if (std::abs(angle) > kPi)
    a = angle - std::copysign(2.0 * kPi, angle);
  return a <= -kPi ? a + 2.0 * kPi : a;
}

}  // namespace hgp
