// Body of the dense kernels.  Role: included once by each dense_kernels_<set>.cpp after it has
// defined, in an unnamed namespace, the vector type of its instruction set:
//   V, kWidth (doubles in V), kTileVectors × kTileCols (register tile), multiplyAdd(a, b, c) = a b + c.
// Everything here has internal linkage and uses no library templates, so that nothing compiled for
// one instruction set can be picked by the linker for another.
// budget: one body for all instruction sets, included as a whole.
#include "hgp/linalg/kernels/dense_product_impl.h"

namespace hgp::linalg {
namespace {

constexpr int kBase = 8;  // columns factored without further blocking

// Cholesky of the top n × n of a panel, n ≤ kBase, entry by entry.
template <bool kComplex>
int factorCorner(int n, double* P, std::ptrdiff_t ld, const double* threshold) {
  constexpr int kStep = kComplex ? 2 : 1;
  for (int j = 0; j < n; ++j) {
    double* column = P + j * ld;
    for (int k = 0; k < j; ++k) {
      const double* other = P + k * ld;
      const double re = other[kStep * j], im = kComplex ? other[kStep * j + 1] : 0.0;
      for (int i = j; i < n; ++i) {
        const double a = other[kStep * i];
        if constexpr (kComplex) {
          const double b = other[kStep * i + 1];
          column[2 * i] -= a * re + b * im;
          column[2 * i + 1] -= b * re - a * im;
        } else {
          column[i] -= a * re;
        }
      }
    }
    const double pivot = column[kStep * j];
    if (!(pivot > threshold[j]) || !(pivot < 1e300)) return j;
    const double root = HGP_SQRT(pivot);
    for (int i = kStep * j; i < kStep * n; ++i) column[i] /= root;
    column[kStep * j] = root;
    if (kComplex) column[kStep * j + 1] = 0.0;
  }
  return -1;
}

// The factor by which row solves multiply each finished column: real, complex, or none.
enum class Scale { kReal, kComplex, kNone };

// Rows x of a panel below its corner L: x := x L⁻ᴴ, `kBlock` vectors of rows at a time. `scale` holds
// the reciprocals of the corner's diagonal.
template <bool kComplex, int kBlock, Scale kScale>
inline void solveRows(int n, const double* L, std::ptrdiff_t ld, const double* scale, double* x) {
  for (int j = 0; j < n; ++j) {
    V value[kBlock];
    for (int v = 0; v < kBlock; ++v) value[v] = load(x + j * ld + v * kWidth);
    for (int k = 0; k < j; ++k) {
      const double* l = L + k * ld + (kComplex ? 2 * j : j);
      const V re = broadcast(-l[0]);
      if constexpr (kComplex) {
        const V im = broadcast(-l[1]) * pairSigns();
        for (int v = 0; v < kBlock; ++v) {
          const V other = load(x + k * ld + v * kWidth);
          value[v] = multiplyAdd(other, re, multiplyAdd(swapPairs(other), im, value[v]));
        }
      } else {
        for (int v = 0; v < kBlock; ++v)
          value[v] = multiplyAdd(load(x + k * ld + v * kWidth), re, value[v]);
      }
    }
    if constexpr (kScale == Scale::kReal) {
      for (int v = 0; v < kBlock; ++v) value[v] = value[v] * broadcast(scale[j]);
    } else if constexpr (kScale == Scale::kComplex) {
      const V re = broadcast(scale[2 * j]), im = broadcast(-scale[2 * j + 1]) * pairSigns();
      for (int v = 0; v < kBlock; ++v) value[v] = value[v] * re + swapPairs(value[v]) * im;
    }
    for (int v = 0; v < kBlock; ++v) store(x + j * ld + v * kWidth, value[v]);
  }
}

// The same for the remaining doubles, fewer than a vector.
template <bool kComplex, Scale kScale>
void solveTail(int count, int n, const double* L, std::ptrdiff_t ld, const double* scale,
               double* x) {
  constexpr int kStep = kComplex ? 2 : 1;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < count; i += kStep) {
      double re = x[j * ld + i], im = kComplex ? x[j * ld + i + 1] : 0.0;
      for (int k = 0; k < j; ++k) {
        const double* l = L + k * ld + kStep * j;
        const double a = x[k * ld + i];
        re -= a * l[0];
        if constexpr (kComplex) {
          const double b = x[k * ld + i + 1];
          re -= b * l[1];
          im -= b * l[0] - a * l[1];
        }
      }
      if constexpr (kScale == Scale::kReal) {
        re *= scale[j];
        im *= scale[j];
      } else if constexpr (kScale == Scale::kComplex) {
        const double old = re;
        re = old * scale[2 * j] - im * scale[2 * j + 1];
        im = old * scale[2 * j + 1] + im * scale[2 * j];
      }
      x[j * ld + i] = re;
      if (kComplex) x[j * ld + i + 1] = im;
    }
}

// Solves the rows from `row` on, all below the corner L.
template <bool kComplex, Scale kScale>
void solveBelow(int row, int rows, int n, const double* L, std::ptrdiff_t ld, const double* scale,
                double* P) {
  constexpr int kStep = kComplex ? 2 : 1;
  const int end = kStep * rows;
  int i = kStep * row;
  for (; i + 4 * kWidth <= end; i += 4 * kWidth)
    solveRows<kComplex, 4, kScale>(n, L, ld, scale, P + i);
  for (; i + kWidth <= end; i += kWidth) solveRows<kComplex, 1, kScale>(n, L, ld, scale, P + i);
  solveTail<kComplex, kScale>(end - i, n, L, ld, scale, P + i);
}

template <bool kComplex>
int factorBase(int rows, int n, double* P, std::ptrdiff_t ld, const double* threshold) {
  constexpr int kStep = kComplex ? 2 : 1;
  const int bad = factorCorner<kComplex>(n, P, ld, threshold);
  if (bad >= 0) return bad;
  double reciprocal[kBase];
  for (int j = 0; j < n; ++j) reciprocal[j] = 1.0 / P[j * ld + kStep * j];
  solveBelow<kComplex, Scale::kReal>(n, rows, n, P, ld, reciprocal, P);
  return -1;
}

// Factors by halves of the columns, so that nearly all work is in matrix products of great depth.
template <bool kComplex>
int factorPanel(int rows, int pivots, double* P, int ld, const double* threshold, double* work) {
  constexpr int kStep = kComplex ? 2 : 1;
  const std::ptrdiff_t stride = static_cast<std::ptrdiff_t>(ld) * kStep;
  if (pivots <= kBase) return factorBase<kComplex>(rows, pivots, P, stride, threshold);
  const int half = (pivots / 2 + kBase - 1) / kBase * kBase;
  const int bad = factorPanel<kComplex>(rows, half, P, ld, threshold, work);
  if (bad >= 0) return bad;
  double* below = P + kStep * half;
  double* rest = below + half * stride;
  update<kComplex>({rows - half, pivots - half, half, below, below, rest, ld, ld, ld, true, false},
                   work);
  const int badRest =
      factorPanel<kComplex>(rows - half, pivots - half, rest, ld, threshold + half, work);
  return badRest < 0 ? -1 : badRest + half;
}

// LU of the n × n corners of P = A and Q = Aᴴ, n ≤ kBase, entry by entry; both lower parts. Returns
// the first bad pivot; reciprocals of U's diagonal go to `scale`.
inline int factorCornerLu(int n, double* P, double* Q, std::ptrdiff_t ld, const double* threshold,
                          double* scale) {
  for (int j = 0; j < n; ++j) {
    for (int k = 0; k < j; ++k) {
      const double *l = P + k * ld, *u = Q + k * ld;
      const double ur = u[2 * j], ui = u[2 * j + 1], lr = l[2 * j], li = l[2 * j + 1];
      double *p = P + j * ld, *q = Q + j * ld;
      for (int i = j; i < n; ++i) {
        p[2 * i] -= l[2 * i] * ur + l[2 * i + 1] * ui;
        p[2 * i + 1] -= l[2 * i + 1] * ur - l[2 * i] * ui;
        q[2 * i] -= u[2 * i] * lr + u[2 * i + 1] * li;
        q[2 * i + 1] -= u[2 * i + 1] * lr - u[2 * i] * li;
      }
    }
    double* p = P + j * ld;
    const double re = p[2 * j], im = p[2 * j + 1], square = re * re + im * im;
    if (!(square > threshold[j] * threshold[j]) || !(square < 1e300)) return j;
    scale[2 * j] = re / square;
    scale[2 * j + 1] = -im / square;
    for (int i = j; i < n; ++i) {
      const double a = p[2 * i], b = p[2 * i + 1];
      p[2 * i] = a * scale[2 * j] - b * scale[2 * j + 1];
      p[2 * i + 1] = a * scale[2 * j + 1] + b * scale[2 * j];
    }
    p[2 * j] = 1.0;
    p[2 * j + 1] = 0.0;
  }
  return -1;
}

inline int factorPanelLu(int rows, int pivots, double* P, double* Q, int ld,
                         const double* threshold, double* work) {
  const std::ptrdiff_t stride = 2 * static_cast<std::ptrdiff_t>(ld);
  if (pivots <= kBase) {
    double scale[2 * kBase];
    const int bad = factorCornerLu(pivots, P, Q, stride, threshold, scale);
    if (bad >= 0) return bad;
    solveBelow<true, Scale::kComplex>(pivots, rows, pivots, Q, stride, scale, P);
    solveBelow<true, Scale::kNone>(pivots, rows, pivots, P, stride, scale, Q);
    return -1;
  }
  const int half = (pivots / 2 + kBase - 1) / kBase * kBase;
  const int bad = factorPanelLu(rows, half, P, Q, ld, threshold, work);
  if (bad >= 0) return bad;
  double *l = P + 2 * half, *u = Q + 2 * half;
  double *restP = l + half * stride, *restQ = u + half * stride;
  const int m = rows - half, n = pivots - half;
  update<true>({m, n, half, l, u, restP, ld, ld, ld, true, false}, work);
  update<true>({m, n, half, u, l, restQ, ld, ld, ld, true, false}, work);
  const int badRest = factorPanelLu(m, n, restP, restQ, ld, threshold + half, work);
  return badRest < 0 ? -1 : badRest + half;
}

}  // namespace
}  // namespace hgp::linalg
