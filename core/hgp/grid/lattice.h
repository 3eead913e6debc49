// The points that a snapped map has: a lattice that the rotations of q keep, and how its points are stored.
// Role: Z[i] for q = 1, 2, 4 and Z[ω] for q = 3, 6, scaled by a power of two.
#pragma once

#include <cmath>

#include "hgp/grid/stored_numbers.h"
#include "hgp/mesh/mesh_data.h"
#include "hgp/seams/eisenstein.h"
#include "hgp/seams/gaussian.h"

namespace hgp {

template <class Ring>
struct Lattice;

/// Multiples of 2^e in u and v: every point is exact where the stored type has digits enough.
template <>
struct Lattice<Gaussian> {
  /// Every 1 − i^r divides it: fixed points of rotations with translations that it divides are in the lattice.
  static constexpr Gaussian kStep{2, 0};
  /// Bits by which a point must be smaller than the largest exact integer.
  static constexpr int kSpareBits = 0;

  static Gaussian point(std::int64_t x, std::int64_t y) { return {x, y}; }
  static std::int64_t x(Gaussian p) { return p.re; }
  static std::int64_t y(Gaussian p) { return p.im; }
  static Gaussian nearest(const Complex& z) {
    return {std::llround(z.real()), std::llround(z.imag())};
  }
  static Vec2 stored(Gaussian p, int exponent) {
    return {std::ldexp(static_cast<double>(p.re), exponent),
            std::ldexp(static_cast<double>(p.im), exponent)};
  }
  static bool fits(Gaussian p, int exponent, const StoredNumbers& numbers) {
    if (numbers.holdsFlipped && (exponent > 0 || exponent < -62)) return false;
    const std::int64_t limit = std::int64_t{1} << numbers.digits;
    const std::int64_t one = numbers.holdsFlipped ? std::int64_t{1} << -exponent : 0;
    return std::abs(p.re) <= limit && std::abs(p.im) <= limit && std::abs(one - p.im) <= limit;
  }
};

/// a + bω in steps of 2^e: u = a − b/2 is exact, v = b √3/2 is stored as the nearest number of the type. The spare
/// bits make that number the nearest of one b only, so that the stored numbers say which point is meant.
template <>
struct Lattice<Eisenstein> {
  static constexpr Eisenstein kStep{2, -2};  ///< 2(1 − ω): 1 − e^{i2πr/6} divides 2 or 1 − ω
  static constexpr int kSpareBits = 2;

  static Eisenstein point(std::int64_t x, std::int64_t y) { return {x, y}; }
  static std::int64_t x(Eisenstein p) { return p.a; }
  static std::int64_t y(Eisenstein p) { return p.b; }
  /// Both coordinates rounded: less than one step away.
  static Eisenstein nearest(const Complex& z) {
    const double b = z.imag() / (0.5 * std::numbers::sqrt3);
    return {std::llround(z.real() + 0.5 * b), std::llround(b)};
  }
  static Vec2 stored(Eisenstein p, int exponent) {
    const Complex z = toComplex(p);
    return {std::ldexp(z.real(), exponent), std::ldexp(z.imag(), exponent)};
  }
  static bool fits(Eisenstein p, int exponent, const StoredNumbers& numbers) {
    const double limit = std::ldexp(1.0, numbers.digits - kSpareBits);
    const double one = numbers.holdsFlipped ? std::ldexp(1.0, -exponent) : 0.0;
    const Complex z = toComplex(p);
    return std::abs(z.real()) <= limit && std::abs(z.imag()) <= limit &&
           std::abs(one - z.imag()) <= limit;
  }
};

}  // namespace hgp
