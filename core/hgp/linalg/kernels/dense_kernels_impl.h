// Body of the dense kernels.  Role: included once by each dense_kernels_<set>.cpp after it has
// defined, in an unnamed namespace, the vector type of its instruction set:
//   V, kWidth (doubles in V), kTileVectors × kTileCols (register tile), multiplyAdd(a, b, c) = a b + c.
// budget: one body for all instruction sets, included as a whole.
// Everything here has internal linkage and uses no library templates, so that nothing compiled for
// one instruction set can be picked by the linker for another.
#include "hgp/linalg/kernels/dense_kernels.h"

// Builtins if available: the linker could use the inline functions of <cmath> compiled here for the whole program.
#if defined(__GNUC__) && !defined(HGP_PORTABLE)
#define HGP_UNROLL _Pragma("GCC unroll 8")
#define HGP_ALWAYS_INLINE inline __attribute__((always_inline))
#define HGP_COPY __builtin_memcpy
#define HGP_SQRT __builtin_sqrt
#else
#include <cmath>
#include <cstring>
#define HGP_UNROLL
#define HGP_ALWAYS_INLINE inline
#define HGP_COPY std::memcpy
#define HGP_SQRT std::sqrt
#endif

namespace hgp::linalg {
namespace {

constexpr int kTileRows = kTileVectors * kWidth;
constexpr int kBase = 8;  // columns factored without further blocking

inline V load(const double* p) {
  V v;
  HGP_COPY(&v, p, sizeof(V));
  return v;
}
inline void store(double* p, V v) { HGP_COPY(p, &v, sizeof(V)); }
inline V broadcast(double x) { return x - V{}; }
inline int minimum(int a, int b) { return a < b ? a : b; }

// Panels of kTileRows rows, depth-major. Complex matrices are packed as real ones of twice the rows.
void packRows(const double* A, int lda, int m, int k, double* out) {
  for (int i = 0; i < m; i += kTileRows) {
    const int rows = minimum(kTileRows, m - i);
    for (int p = 0; p < k; ++p, out += kTileRows) {
      const double* column = A + i + static_cast<std::ptrdiff_t>(p) * lda;
      if (rows == kTileRows) {
        for (int v = 0; v < kTileVectors; ++v) store(out + v * kWidth, load(column + v * kWidth));
      } else {
        for (int r = 0; r < kTileRows; ++r) out[r] = r < rows ? column[r] : 0.0;
      }
    }
  }
}

// Panels of kTileCols rows of B, depth-major; for complex B a row gives two columns, re and im.
void packCols(const double* B, int ldb, int n, int k, double* out) {
  for (int j = 0; j < n; j += kTileCols) {
    const int cols = minimum(kTileCols, n - j);
    for (int p = 0; p < k; ++p, out += kTileCols) {
      const double* column = B + j + static_cast<std::ptrdiff_t>(p) * ldb;
      for (int c = 0; c < kTileCols; ++c) out[c] = c < cols ? column[c] : 0.0;
    }
  }
}

struct Tile {
  V sum[kTileCols][kTileVectors];
};

HGP_ALWAYS_INLINE void multiplyTile(int k, const double* a, const double* b, Tile* tile) {
  V sum[kTileCols][kTileVectors] = {};
  for (int p = 0; p < k; ++p, a += kTileRows, b += kTileCols) {
    V left[kTileVectors];
    HGP_UNROLL
    for (int v = 0; v < kTileVectors; ++v) left[v] = load(a + v * kWidth);
    HGP_UNROLL
    for (int c = 0; c < kTileCols; ++c) {
      const V right = broadcast(b[c]);
      HGP_UNROLL
      for (int v = 0; v < kTileVectors; ++v) sum[c][v] = multiplyAdd(left[v], right, sum[c][v]);
    }
  }
  HGP_UNROLL
  for (int c = 0; c < kTileCols; ++c) HGP_UNROLL
  for (int v = 0; v < kTileVectors; ++v) tile->sum[c][v] = sum[c][v];
}

// (a b̄) from the products of (a_re, a_im) with b_re and with b_im.
inline V conjugateProduct(V withRe, V withIm) { return withRe + swapPairs(withIm) * pairSigns(); }

// Subtracts a tile from rows × cols (in doubles) of C.
template <bool kComplex>
inline void subtractTile(const Tile& tile, int rows, int cols, bool overwrite, double* C, int ldc) {
  constexpr int kStep = kComplex ? 2 : 1;
  for (int c = 0; c < cols; c += kStep) {
    double* column = C + static_cast<std::ptrdiff_t>(c / kStep) * ldc;
    V result[kTileVectors];
    for (int v = 0; v < kTileVectors; ++v) {
      if constexpr (kComplex)
        result[v] = conjugateProduct(tile.sum[c][v], tile.sum[c + 1][v]);
      else
        result[v] = tile.sum[c][v];
    }
    if (rows == kTileRows) {
      for (int v = 0; v < kTileVectors; ++v)
        store(column + v * kWidth, (overwrite ? V{} : load(column + v * kWidth)) - result[v]);
    } else {
      double values[kTileRows];
      for (int v = 0; v < kTileVectors; ++v) store(values + v * kWidth, result[v]);
      for (int r = 0; r < rows; ++r) column[r] = (overwrite ? 0.0 : column[r]) - values[r];
    }
  }
}

// One packed block of A against one packed block of B. Tiles wholly above the diagonal of C (row
// offset − column offset = `diagonal`, in scalars) are skipped when only the lower part is wanted.
template <bool kComplex>
void multiplyPacked(int m, int n, int k, const double* a, const double* b, double* C, int ldc,
                    bool lower, int diagonal, bool overwrite) {
  constexpr int kStep = kComplex ? 2 : 1;
  Tile tile;
  for (int j = 0; j < n; j += kTileCols) {
    const int cols = minimum(kTileCols, n - j);
    int first = 0;
    if (lower) {
      const int row = (j / kStep - diagonal) * kStep;  // first row on the diagonal, in doubles
      if (row > 0) first = row / kTileRows * kTileRows;
    }
    for (int i = first; i < m; i += kTileRows) {
      multiplyTile(k, a + static_cast<std::ptrdiff_t>(i) * k,
                   b + static_cast<std::ptrdiff_t>(j) * k, &tile);
      subtractTile<kComplex>(tile, minimum(kTileRows, m - i), cols, overwrite,
                             C + i + static_cast<std::ptrdiff_t>(j / kStep) * ldc, ldc);
    }
  }
}

template <bool kComplex>
void update(const KernelTable::Update& t, double* work) {
  constexpr int kStep = kComplex ? 2 : 1;
  double* packedA = work;
  double* packedB = work + static_cast<std::ptrdiff_t>(kPackRows + 32) * kPackDepth;
  constexpr int kRows = kPackRows / kStep, kCols = kPackCols / kStep;
  const int lda = kStep * t.lda, ldb = kStep * t.ldb, ldc = kStep * t.ldc;
  for (int j = 0; j < t.n; j += kCols) {
    const int n = minimum(kCols, t.n - j);
    for (int p = 0; p < t.k; p += kPackDepth) {
      const int k = minimum(kPackDepth, t.k - p);
      packCols(t.B + kStep * j + static_cast<std::ptrdiff_t>(p) * ldb, ldb, kStep * n, k, packedB);
      for (int i = t.lower ? j / kRows * kRows : 0; i < t.m; i += kRows) {
        const int m = minimum(kRows, t.m - i);
        packRows(t.A + kStep * i + static_cast<std::ptrdiff_t>(p) * lda, lda, kStep * m, k,
                 packedA);
        multiplyPacked<kComplex>(kStep * m, kStep * n, k, packedA, packedB,
                                 t.C + kStep * i + static_cast<std::ptrdiff_t>(j) * ldc, ldc,
                                 t.lower, i - j, t.overwrite && p == 0);
      }
    }
  }
}

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
