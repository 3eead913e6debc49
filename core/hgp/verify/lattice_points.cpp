#include "hgp/verify/lattice_points.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace hgp {
namespace {

constexpr double kHalfRootOf3 = 0.5 * std::numbers::sqrt3;
constexpr double kMaxHalfSteps = 0x1p53;  ///< of u, which is exact
/// Stored numbers are at least this much finer than the lattice: the smallest by the power of two of which all are
/// multiples, the largest by the digits of a double.
constexpr double kFinerThan = 0.25;
constexpr double kMaxSteps = 0x1p51;  ///< of v

/// The exponent of the lowest set bit of x. @pre finite, not 0
int lowestBit(double x) {
  int exponent = 0;
  const double fraction = std::frexp(std::abs(x), &exponent);
  const auto digits = static_cast<std::uint64_t>(std::ldexp(fraction, 53));
  return exponent - 53 + std::countr_zero(digits);
}

/// The powers of two of which the stored numbers are multiples.
struct Steps {
  int exponent;  ///< of the lattice
  double v;      ///< of the stored v
};

std::optional<SeamPoint> pointAt(const Vec2& uv, const Steps& steps) {
  const double halves = std::ldexp(uv[0], 1 - steps.exponent);
  const double rows = std::rint(std::ldexp(uv[1], -steps.exponent) / kHalfRootOf3);
  if (!(std::abs(halves) <= kMaxHalfSteps)) return {};
  if (!(std::abs(std::ldexp(uv[1], -steps.exponent)) <= kMaxSteps)) return {};
  const double exact = std::ldexp(kHalfRootOf3 * rows, steps.exponent);
  if (halves != std::rint(halves) || uv[1] != steps.v * std::rint(exact / steps.v)) return {};
  const auto m = static_cast<std::int64_t>(halves), b = static_cast<std::int64_t>(rows);
  if ((m + b) % 2 != 0) return {};
  return SeamPoint{(m + b) / 2, b};
}

std::optional<LatticePoints> pointsAt(const CornerUv& uv, const Steps& steps) {
  if (steps.v > kFinerThan * std::ldexp(1.0, steps.exponent)) return {};
  LatticePoints points{steps.exponent, {}};
  points.corner.reserve(uv.size());
  for (const Vec2& p : uv.raw()) {
    const std::optional<SeamPoint> point = pointAt(p, steps);
    if (!point) return {};
    points.corner.push_back(*point);
  }
  return points;
}

}  // namespace

SeamPoint turnedBySixths(int sixths, SeamPoint p) {
  // e^{i2π/6} = 1 + ω: (a + bω)(1 + ω) = (a − b) + aω, as ω² = −1 − ω.
  for (int k = 0; k < sixths; ++k) p = {p.a - p.b, p.a};
  return p;
}

std::optional<LatticePoints> latticePoints(const CornerUv& uv) {
  constexpr int kNone = 4096;
  int lowest[2] = {kNone, kNone};
  for (const Vec2& p : uv.raw())
    for (std::size_t k = 0; k < 2; ++k) {
      if (!std::isfinite(p[k])) return {};
      if (p[k] != 0.0) lowest[k] = std::min(lowest[k], lowestBit(p[k]));
    }
  if (lowest[0] == kNone || lowest[1] == kNone) return {};
  // In the largest possible step u is an odd number of halves somewhere; in one half as large, b is even
  // wherever u is a multiple of it.
  const double v = std::ldexp(1.0, lowest[1]);
  std::optional<LatticePoints> points = pointsAt(uv, {lowest[0] + 1, v});
  return points ? points : pointsAt(uv, {lowest[0], v});
}

}  // namespace hgp
