// Triangular solves with one panel.  Role: loops with a fixed order of additions, so that solutions have the same bits on
// every processor; in Eigen the order depends on the vector width, and complex quotients depend on the compiler.
#pragma once

#include <complex>

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

/// Complex numbers of one row of four right-hand sides: real parts, then imaginary parts.
struct FourComplex {
  double re[4], im[4];
  void set(int c, const std::complex<double>& z) { re[c] = z.real(), im[c] = z.imag(); }
};

/// conjugateDot with each of four right-hand sides, with the same bits.
inline FourComplex conjugateDot(int count, const std::complex<double>* p, const FourComplex* w) {
  FourComplex lane[2] = {};
  for (int i = 0; i < count; ++i) {
    FourComplex& sum = lane[i % 2];
    const double a = p[i].real(), b = p[i].imag();
    for (int c = 0; c < 4; ++c) {
      sum.re[c] += a * w[i].re[c] + b * w[i].im[c];
      sum.im[c] += a * w[i].im[c] - b * w[i].re[c];
    }
  }
  for (int c = 0; c < 4; ++c) {
    lane[0].re[c] += lane[1].re[c];
    lane[0].im[c] += lane[1].im[c];
  }
  return lane[0];
}

/// A panel of `pivots` columns and `rows` rows, column-major: L11 (lower) over L21.
template <class Scalar>
struct Panel {
  const Scalar* values;
  int rows, pivots;

  const Scalar* column(int k) const { return values + static_cast<std::ptrdiff_t>(k) * rows; }

  /// w holds `rows` entries: the first `pivots` become L11⁻¹ w1, the others w2 − L21 L11⁻¹ w1.
  void forward(Scalar* w) const {
    for (int k = 0; k < pivots; ++k) {
      const Scalar* const p = column(k);
      w[k] = quotient(w[k], p[k]);
      subtractMultiple(rows - k - 1, p + k + 1, w[k], w + k + 1);
    }
  }

  /// The first `pivots` entries of w become L11⁻ᴴ (w1 − L21ᴴ w2); the others stay.
  void backward(Scalar* w) const {
    for (int k = pivots - 1; k >= 0; --k) {
      const Scalar* const p = column(k);
      const Scalar rest = w[k] - conjugateDot(rows - k - 1, p + k + 1, w + k + 1);
      if constexpr (sizeof(Scalar) == sizeof(double))
        w[k] = rest / p[k];
      else
        w[k] = quotient(rest, std::conj(p[k]));
    }
  }

  /// The same for four right-hand sides, with the same bits.
  void backward(FourComplex* w) const {
    for (int k = pivots - 1; k >= 0; --k) {
      const Scalar* const p = column(k);
      const FourComplex dot = conjugateDot(rows - k - 1, p + k + 1, w + k + 1);
      const Scalar pivot = std::conj(p[k]);
      for (int c = 0; c < 4; ++c) {
        const Scalar rest(w[k].re[c] - dot.re[c], w[k].im[c] - dot.im[c]);
        w[k].set(c, quotient(rest, pivot));
      }
    }
  }
};

}  // namespace hgp::linalg
