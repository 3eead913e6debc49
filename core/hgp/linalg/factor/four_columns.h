// Sums over the columns of a panel, with four right-hand sides at a time.  Role: the bits of panel_sums.h for each of them,
// with a quarter of the loads.
#pragma once

#include <complex>
#include <type_traits>

namespace hgp::linalg {

/// Numbers of one row of four right-hand sides.
struct FourReal {
  double v[4];
  void set(int c, double z) { v[c] = z; }
  double at(int c) const { return v[c]; }
};

/// conjugateDot with each of four right-hand sides, with the same bits.
inline FourReal conjugateDot(int count, const double* p, const FourReal* w) {
  double lane[4][4] = {};
  int i = 0;
  const auto add = [&](int k) {
    for (int c = 0; c < 4; ++c) lane[k][c] += p[i + k] * w[i + k].v[c];
  };
  for (; i + 4 <= count; i += 4) add(0), add(1), add(2), add(3);
  for (int k = 0; i + k < count; ++k) add(k);
  FourReal sum;
  for (int c = 0; c < 4; ++c) sum.v[c] = (lane[0][c] + lane[1][c]) + (lane[2][c] + lane[3][c]);
  return sum;
}

/// Complex numbers of one row of four right-hand sides: real parts, then imaginary parts.
struct FourComplex {
  double re[4], im[4];
  void set(int c, const std::complex<double>& z) { re[c] = z.real(), im[c] = z.imag(); }
  std::complex<double> at(int c) const { return {re[c], im[c]}; }
};
template <class Scalar>
using Four = std::conditional_t<sizeof(Scalar) == sizeof(double), FourReal, FourComplex>;

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

}  // namespace hgp::linalg
