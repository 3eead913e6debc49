#include "hgp/base/portable_math.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

namespace hgp::portable {
namespace {

using std::numbers::pi;

/// c[0] + c[1] z + … by Horner's rule.
template <std::size_t N>
double polynomial(const double (&c)[N], double z) {
  double sum = c[N - 1];
  for (std::size_t i = N - 1; i-- > 0;) sum = c[i] + z * sum;
  return sum;
}

// ln 2 = kLn2High + kLn2Low; small multiples of the first are exact (32 bits).
constexpr double kLn2High = 0x1.62e42feep-1, kLn2Low = 0x1.a39ef35793c76p-33;

// π/2 in three parts of 33, 33 and 53 bits: n times either of the first two is exact for |n| ≤ 2²⁰.
constexpr double kHalfPi[] = {0x1.921fb544p+0, 0x1.0b4611a6p-34, 0x1.3198a2e037073p-69};
constexpr double kLargestReduced = 1e6;

/// x = n π/2 + high + low, |high| ≤ π/4 (and a little), low below its last place.
struct Reduced {
  int quadrant;  // n mod 4
  double high, low;
};

Reduced reduce(double x) {
  if (!(std::fabs(x) < kLargestReduced)) x = std::remainder(x, 2.0 * pi);
  if (std::isnan(x)) return {0, x, 0.0};
  const double n = std::nearbyint(x * (2.0 / pi));
  const double a = x - n * kHalfPi[0];  // exact: x and n π/2 are within a factor of two, or n = 0
  const double b = n * kHalfPi[1];
  // a − b and its rounding error, whichever of a and b is larger [Knuth].
  const double c = a - b, taken = a - c;
  const double rest = ((a - (c + taken)) + (taken - b)) - n * kHalfPi[2];
  const double high = c + rest, low = (c - high) + rest;
  return {static_cast<int>(static_cast<long long>(n) & 3), high, low};
}

/// Taylor's series on |x| ≤ π/4: the first omitted term is below 1e-19 of the result.
double sineSeries(const Reduced& r) {
  static constexpr double kTerms[] = {
      -1.0 / 6,        1.0 / 120,        -1.0 / 5040,         1.0 / 362880,
      -1.0 / 39916800, 1.0 / 6227020800, -1.0 / 1307674368e3, 1.0 / 355687428096e3};
  const double z = r.high * r.high;
  return r.high + (r.low * (1.0 - 0.5 * z) + r.high * z * polynomial(kTerms, z));
}

double cosineSeries(const Reduced& r) {
  static constexpr double kTerms[] = {
      1.0 / 24,        -1.0 / 720,         1.0 / 40320,         -1.0 / 3628800,
      1.0 / 479001600, -1.0 / 87178291200, 1.0 / 20922789888e3, -1.0 / 6402373705728e3};
  const double z = r.high * r.high, half = 0.5 * z, w = 1.0 - half;
  return w + (((1.0 - w) - half) + (z * z * polynomial(kTerms, z) - r.high * r.low));
}

struct SineCosine {
  double sine, cosine;
};

SineCosine sineCosine(double x) {
  const Reduced r = reduce(x);
  const double s = sineSeries(r), c = cosineSeries(r);
  switch (r.quadrant) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

/// atan(n / 8) as the nearest double and the remainder.
constexpr double kArcTangent[][2] = {{0.0, 0.0},
                                     {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
                                     {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
                                     {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
                                     {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
                                     {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
                                     {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
                                     {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
                                     {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55}};
constexpr double kHalfPiLow = 0x1.1a62633145c07p-54, kPiLow = 0x1.1a62633145c07p-53;

/// atan(a / b), 0 ≤ a ≤ b: atan(n/8) + atan((a − b n/8) / (b + a n/8)), the second by its series.
std::pair<double, double> firstOctant(double a, double b) {
  static constexpr double kTerms[] = {-1.0 / 3,  1.0 / 5,  -1.0 / 7,  1.0 / 9,
                                      -1.0 / 11, 1.0 / 13, -1.0 / 15, 1.0 / 17};
  const int n = static_cast<int>(std::lround(8.0 * (a / b)));
  const double c = 0.125 * n;
  const double u = n == 0 ? a / b : (a - c * b) / (b + c * a);
  const double z = u * u;
  return {kArcTangent[n][0], u + (kArcTangent[n][1] + u * z * polynomial(kTerms, z))};
}

/// x · 2ᵉ; exact unless the result is subnormal.
double scaled(double x, int e) { return std::ldexp(x, e); }

/// Whether squares of numbers of this size neither overflow nor underflow.
bool isTame(double largest) { return largest > 1e-140 && largest < 1e140; }

}  // namespace

double exp(double x) {
  if (std::isnan(x)) return x;
  if (x > 709.8) return std::numeric_limits<double>::infinity();
  if (x < -745.2) return 0.0;
  static constexpr double kTerms[] = {
      1.0 / 2,     1.0 / 6,      1.0 / 24,      1.0 / 120,      1.0 / 720,       1.0 / 5040,
      1.0 / 40320, 1.0 / 362880, 1.0 / 3628800, 1.0 / 39916800, 1.0 / 479001600, 1.0 / 6227020800};
  const double n = std::nearbyint(x * std::numbers::log2e);
  const double a = x - n * kLn2High, b = n * kLn2Low;
  const double r = a - b, low = (a - r) - b;
  return scaled(1.0 + (r + (low + r * r * polynomial(kTerms, r))), static_cast<int>(n));
}

double log(double x) {
  if (std::isnan(x) || x < 0) return std::numeric_limits<double>::quiet_NaN();
  if (x == 0) return -std::numeric_limits<double>::infinity();
  if (std::isinf(x)) return x;
  // x = 2ᵉ (1 + f), √½ ≤ 1 + f < √2; log(1 + f) = 2 artanh(s), s = f / (2 + f).
  static constexpr double kTerms[] = {2.0 / 3,  2.0 / 5,  2.0 / 7,  2.0 / 9,  2.0 / 11,
                                      2.0 / 13, 2.0 / 15, 2.0 / 17, 2.0 / 19, 2.0 / 21};
  int e = 0;
  double m = std::frexp(x, &e);
  if (m < std::numbers::sqrt2 / 2) {
    m *= 2;
    --e;
  }
  const double f = m - 1.0, s = f / (2.0 + f), z = s * s, half = 0.5 * f * f;
  // 2s = f − s f and s f = f²/2 − s f²/2: the leading terms f − f²/2 need no division.
  const double rest = s * (half + z * polynomial(kTerms, z));
  return e * kLn2High - ((half - (rest + e * kLn2Low)) - f);
}

double log1p(double x) {
  const double u = 1.0 + x;
  // The factor compensates for the rounding of 1 + x [Kahan].
  return u == 1.0 ? x : log(u) * (x / (u - 1.0));
}

double log2(double x) {
  int e = 0;
  const double m = std::frexp(x, &e);
  return m == 0.5 ? e - 1 : log(x) * std::numbers::log2e;
}

double pow(double x, double y) {
  if (y == 0 || x == 1) return 1.0;
  return exp(y * log(x));
}

double cosh(double x) {
  const double e = exp(std::fabs(x));
  return std::isinf(e) ? e : 0.5 * (e + 1.0 / e);
}

double tanh(double x) {
  const double e = exp(-2.0 * std::fabs(x));
  return std::copysign((1.0 - e) / (1.0 + e), x);
}

double sin(double x) { return sineCosine(x).sine; }
double cos(double x) { return sineCosine(x).cosine; }

double tan(double x) {
  const auto [s, c] = sineCosine(x);
  return s / c;
}

double atan2(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return x + y;
  double a = std::fabs(y), b = std::fabs(x);
  const bool isSteep = a > b;
  if (isSteep) std::swap(a, b);
  if (std::isinf(b)) {  // along an axis or, if both are infinite, a diagonal
    a = std::isinf(a) ? 1.0 : 0.0;
    b = 1.0;
  }
  std::pair<double, double> angle{0.0, 0.0};
  if (b > 0) {
    if (!isTame(b)) {
      const int e = -std::ilogb(b);
      a = scaled(a, e);
      b = scaled(b, e);
    }
    angle = firstOctant(a, b);
  }
  auto [high, low] = angle;
  if (isSteep) {
    high = pi / 2 - high;  // the rounding error is added to the low part
    low = ((pi / 2 - high) - angle.first) + (kHalfPiLow - low);
  }
  if (std::signbit(x)) {
    const double before = high;
    high = pi - before;
    low = ((pi - high) - before) + (kPiLow - low);
  }
  return std::copysign(high + low, y);
}

double asin(double x) { return atan2(x, std::sqrt((1.0 - x) * (1.0 + x))); }
double acos(double x) { return 2.0 * atan2(std::sqrt(1.0 - x), std::sqrt(1.0 + x)); }

double hypot(double x, double y) { return hypot(x, y, 0.0); }

double hypot(double x, double y, double z) {
  const double largest = std::max({std::fabs(x), std::fabs(y), std::fabs(z)});
  if (isTame(largest)) return std::sqrt(x * x + y * y + z * z);
  if (largest == 0 || std::isinf(largest) || std::isnan(x + y + z)) return std::fabs(x + y + z);
  const int e = std::ilogb(largest);
  const double a = scaled(x, -e), b = scaled(y, -e), c = scaled(z, -e);
  return scaled(std::sqrt(a * a + b * b + c * c), e);
}

double abs(const std::complex<double>& z) { return hypot(z.real(), z.imag()); }
double arg(const std::complex<double>& z) { return atan2(z.imag(), z.real()); }

std::complex<double> polar(double radius, double angle) {
  const auto [s, c] = sineCosine(angle);
  return {radius * c, radius * s};
}

std::complex<double> divide(const std::complex<double>& a, const std::complex<double>& b) {
  double re = b.real(), im = b.imag();
  const double largest = std::max(std::fabs(re), std::fabs(im));
  int e = 0;
  if (!isTame(largest) && largest > 0 && std::isfinite(largest)) {
    e = -std::ilogb(largest);
    re = scaled(re, e);
    im = scaled(im, e);
  }
  const double square = re * re + im * im;
  const double x = (a.real() * re + a.imag() * im) / square;
  const double y = (a.imag() * re - a.real() * im) / square;
  return {scaled(x, e), scaled(y, e)};
}

}  // namespace hgp::portable
