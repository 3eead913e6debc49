// Body of the dense kernels.  Role: included once by each dense_kernels_<set>.cpp after it has
// defined, in an unnamed namespace, the vector type of its instruction set:
//   V, kWidth (doubles in V), kTileVectors × kTileCols (register tile), multiplyAdd(a, b, c) = a b + c.
// Everything here has internal linkage and uses no library templates, so that nothing compiled for
// one instruction set can be picked by the linker for another.
#include "hgp/linalg/dense_kernels.h"

namespace hgp::linalg {
namespace {

constexpr int kTileRows = kTileVectors * kWidth;
constexpr int kBase = 8;  // columns factored without further blocking

inline V load(const double* p) {
  V v;
  __builtin_memcpy(&v, p, sizeof(V));
  return v;
}
inline void store(double* p, V v) { __builtin_memcpy(p, &v, sizeof(V)); }
inline V broadcast(double x) { return x - V{}; }
inline int minimum(int a, int b) { return a < b ? a : b; }

// Panels of kTileRows rows, depth-major. Complex matrices are packed as real ones of twice the rows.
void packRows(const double* A, int lda, int m, int k, double* out) {
  for (int i = 0; i < m; i += kTileRows) {
    const int rows = minimum(kTileRows, m - i);
    for (int p = 0; p < k; ++p, out += kTileRows) {
      const double* column = A + i + static_cast<std::ptrdiff_t>(p) * lda;
      if (rows == kTileRows) {
        for (int v = 0; v < kTileVectors; ++v)
          store(out + v * kWidth, load(column + v * kWidth));
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

inline __attribute__((always_inline)) void multiplyTile(int k, const double* a, const double* b,
                                                        Tile* tile) {
  V sum[kTileCols][kTileVectors] = {};
  for (int p = 0; p < k; ++p, a += kTileRows, b += kTileCols) {
    V left[kTileVectors];
#pragma GCC unroll 8
    for (int v = 0; v < kTileVectors; ++v) left[v] = load(a + v * kWidth);
#pragma GCC unroll 8
    for (int c = 0; c < kTileCols; ++c) {
      const V right = broadcast(b[c]);
#pragma GCC unroll 8
      for (int v = 0; v < kTileVectors; ++v) sum[c][v] = multiplyAdd(left[v], right, sum[c][v]);
    }
  }
#pragma GCC unroll 8
  for (int c = 0; c < kTileCols; ++c)
#pragma GCC unroll 8
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
        store(column + v * kWidth,
              (overwrite ? V{} : load(column + v * kWidth)) - result[v]);
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
      multiplyTile(k, a + static_cast<std::ptrdiff_t>(i) * k, b + static_cast<std::ptrdiff_t>(j) * k,
                   &tile);
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
        packRows(t.A + kStep * i + static_cast<std::ptrdiff_t>(p) * lda, lda, kStep * m, k, packedA);
        multiplyPacked<kComplex>(kStep * m, kStep * n, k, packedA, packedB,
                                 t.C + kStep * i + static_cast<std::ptrdiff_t>(j) * ldc, ldc, t.lower,
                                 i - j, t.overwrite && p == 0);
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
    const double root = __builtin_sqrt(pivot);
    for (int i = kStep * j; i < kStep * n; ++i) column[i] /= root;
    column[kStep * j] = root;
    if (kComplex) column[kStep * j + 1] = 0.0;
  }
  return -1;
}

// Rows x of a panel below its corner L: x := x L⁻ᴴ, `kBlock` vectors of rows at a time.
template <bool kComplex, int kBlock>
inline void solveRows(int n, const double* L, std::ptrdiff_t ld, const double* reciprocal,
                      double* x) {
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
    const V scale = broadcast(reciprocal[j]);
    for (int v = 0; v < kBlock; ++v) store(x + j * ld + v * kWidth, value[v] * scale);
  }
}

// The same for the last few doubles, fewer than a vector.
template <bool kComplex>
void solveTail(int count, int n, const double* L, std::ptrdiff_t ld, const double* reciprocal,
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
      x[j * ld + i] = re * reciprocal[j];
      if (kComplex) x[j * ld + i + 1] = im * reciprocal[j];
    }
}

template <bool kComplex>
int factorBase(int rows, int n, double* P, std::ptrdiff_t ld, const double* threshold) {
  constexpr int kStep = kComplex ? 2 : 1;
  const int bad = factorCorner<kComplex>(n, P, ld, threshold);
  if (bad >= 0) return bad;
  double reciprocal[kBase];
  for (int j = 0; j < n; ++j) reciprocal[j] = 1.0 / P[j * ld + kStep * j];
  const int end = kStep * rows;
  int i = kStep * n;
  for (; i + 4 * kWidth <= end; i += 4 * kWidth)
    solveRows<kComplex, 4>(n, P, ld, reciprocal, P + i);
  for (; i + kWidth <= end; i += kWidth) solveRows<kComplex, 1>(n, P, ld, reciprocal, P + i);
  solveTail<kComplex>(end - i, n, P, ld, reciprocal, P + i);
  return -1;
}

// Halves the columns, so that nearly all work is products of great depth.
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

}  // namespace
}  // namespace hgp::linalg
