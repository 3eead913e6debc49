// Products of dense matrices in packed tiles.  Role: the part of the dense kernels in which nearly all time is spent; see
// dense_kernels_impl.h, which includes it, for what must be defined before.
// budget: one body for all instruction sets, included as a whole.
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

}  // namespace
}  // namespace hgp::linalg
