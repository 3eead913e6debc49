// Triangular solves with one panel.
#pragma once

#include "hgp/linalg/factor/four_columns.h"
#include "hgp/linalg/factor/panel_sums.h"

namespace hgp::linalg {

/// A panel of `pivots` columns and `rows` rows, column-major: L11 (lower) over L21.
template <class Scalar>
struct Panel {
  const Scalar* values;
  int rows, pivots;

  const Scalar* column(int k) const { return values + static_cast<std::ptrdiff_t>(k) * rows; }

  /// w holds `rows` entries: the first `pivots` become L11⁻¹ w1, the others w2 − L21 L11⁻¹ w1.
  void forward(Scalar* w) const {
    int k = 0;
    if constexpr (sizeof(Scalar) == sizeof(double))
      for (; k + 4 <= pivots; k += 4) {
        step(k, k + 4, k + 4, w);
        subtractFourMultiples(rows - k - 4, column(k) + k + 4, rows, w + k, w + k + 4);
      }
    step(k, pivots, rows, w);
  }

  /// The steps of forward() for pivots first … last − 1, as far as row `end`.
  void step(int first, int last, int end, Scalar* w) const {
    for (int k = first; k < last; ++k) {
      const Scalar* const p = column(k);
      w[k] = quotient(w[k], p[k]);
      subtractMultiple(end - k - 1, p + k + 1, w[k], w + k + 1);
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
  void backward(FourReal* w) const {
    for (int k = pivots - 1; k >= 0; --k) {
      const Scalar* const p = column(k);
      const FourReal dot = conjugateDot(rows - k - 1, p + k + 1, w + k + 1);
      for (int c = 0; c < 4; ++c) w[k].v[c] = (w[k].v[c] - dot.v[c]) / p[k];
    }
  }
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
