// Sums over the columns of a panel.  Role: loops with a fixed order of additions, so that solutions have the same bits on
// every processor; in Eigen the order depends on the vector width, and complex quotients depend on the compiler.
#pragma once

#include <complex>
#include <cstddef>

#include "hgp/base/portable_math.h"

namespace hgp::linalg {

inline double quotient(double a, double b) { return a / b; }
inline std::complex<double> quotient(const std::complex<double>& a, const std::complex<double>& b) {
  return portable::divide(a, b);
}

/// w := w − p x, `count` entries.
inline void subtractMultiple(int count, const double* p, double x, double* w) {
  for (int i = 0; i < count; ++i) w[i] -= p[i] * x;
}
inline void subtractMultiple(int count, const std::complex<double>* p,
                             const std::complex<double>& x, std::complex<double>* w) {
  const auto* from = reinterpret_cast<const double*>(p);
  auto* to = reinterpret_cast<double*>(w);
  const double re = x.real(), im = x.imag();
  for (int i = 0; i < 2 * count; i += 2) {
    to[i] -= from[i] * re - from[i + 1] * im;
    to[i + 1] -= from[i] * im + from[i + 1] * re;
  }
}

/// w := (((w − p x₀) − p′ x₁) − p″ x₂) − p‴ x₃ for four columns p, p′, …, `stride` entries apart: the bits of four steps, with
/// a quarter of the loads and stores.
inline void subtractFourMultiples(int count, const double* p, std::ptrdiff_t stride,
                                  const double* x, double* w) {
  const double *const p1 = p + stride, *const p2 = p1 + stride, *const p3 = p2 + stride;
  const double x0 = x[0], x1 = x[1], x2 = x[2], x3 = x[3];
  for (int i = 0; i < count; ++i)
    w[i] = (((w[i] - p[i] * x0) - p1[i] * x1) - p2[i] * x2) - p3[i] * x3;
}

/// Σ p̄ w over `count` entries, in four interleaved sums that are added pairwise.
inline double conjugateDot(int count, const double* p, const double* w) {
  double lane[4] = {};
  int i = 0;
  for (; i + 4 <= count; i += 4)
    for (int k = 0; k < 4; ++k) lane[k] += p[i + k] * w[i + k];
  for (int k = 0; i < count; ++i, ++k) lane[k] += p[i] * w[i];
  return (lane[0] + lane[1]) + (lane[2] + lane[3]);
}
inline std::complex<double> conjugateDot(int count, const std::complex<double>* p,
                                         const std::complex<double>* w) {
  const auto* a = reinterpret_cast<const double*>(p);
  const auto* b = reinterpret_cast<const double*>(w);
  double re[2] = {}, im[2] = {};
  for (int i = 0; i < 2 * count; i += 2) {
    const int k = (i / 2) % 2;
    re[k] += a[i] * b[i] + a[i + 1] * b[i + 1];
    im[k] += a[i] * b[i + 1] - a[i + 1] * b[i];
  }
  return {re[0] + re[1], im[0] + im[1]};
}

}  // namespace hgp::linalg
