// Rotations by multiples of 2π/q, kept as integers.  Role: Z_q of [BCW17 §3.3].
#pragma once

#include <complex>
#include <numbers>

namespace hgp {

using Complex = std::complex<double>;
inline constexpr double kPi = std::numbers::pi;

/// r reduced to {0, …, q − 1}.
constexpr int reduceTurn(long long r, int q) {
  const long long m = r % q;
  return static_cast<int>(m < 0 ? m + q : m);
}

/// e^{i2πr/q}; exact (0, ±1, ±i) wherever the angle is a multiple of a quarter turn, and correctly
/// paired: rotation(r, q) and rotation(−r, q) are exact conjugates.
Complex rotation(long long r, int q);

/// 2πr/q in radians, for places where an angle is truly continuous.
constexpr double turnAngle(double r, int q) { return 2.0 * kPi * r / q; }

/// The representative of `angle` in (−π, π].
double principalAngle(double angle);

}  // namespace hgp
