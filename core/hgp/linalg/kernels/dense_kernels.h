// The dense inner loops.  Role: the only code that is compiled once per instruction set; all other code
// calls it through a table of functions.
#pragma once

#include <cstddef>

namespace hgp::linalg {

/// Matrices are column-major with a leading dimension counted in scalars; complex numbers are
/// (re, im) pairs of doubles. `work` holds kKernelWorkspace doubles, 64-byte aligned.
struct KernelTable {
  const char* name;

  /// C (m × n) := C − A Bᴴ, A m × k, B n × k; `overwrite` starts from C = 0. With `lower` only
  /// entries on and below the diagonal of C are defined afterwards; those above may hold anything.
  struct Update {
    int m, n, k;
    const double *A, *B;
    double* C;
    int lda, ldb, ldc;
    bool lower, overwrite;
  };
  void (*updateReal)(const Update& task, double* work);
  void (*updateComplex)(const Update& task, double* work);

  /// Factors the first `pivots` columns of a tall panel (rows ≥ pivots) in place: the top square
  /// becomes L11 (lower; undefined above), the rest L21 = A21 L11⁻ᴴ. Stops at the first pivot that
  /// is not > threshold[j] and returns j; −1 on success.
  int (*factorPanelReal)(int rows, int pivots, double* panel, int ld, const double* threshold,
                         double* work);
  int (*factorPanelComplex)(int rows, int pivots, double* panel, int ld, const double* threshold,
                            double* work);

  /// Complex A = L U without pivoting, the panel given twice: P holds the pivot columns of A and Q
  /// those of Aᴴ, both rows × pivots, lower part. P becomes L (unit diagonal, not stored: P keeps 1),
  /// Q becomes Uᴴ. Returns the first j whose pivot is not of modulus > threshold[j], or −1.
  int (*factorPanelLu)(int rows, int pivots, double* P, double* Q, int ld, const double* threshold,
                       double* work);
};

inline constexpr int kPackRows = 192;   // rows of A packed at a time: with kPackDepth, half of L2
inline constexpr int kPackDepth = 256;  // depth of one packed product
inline constexpr int kPackCols = 1024;  // columns of Bᴴ packed at a time
inline constexpr std::size_t kKernelWorkspace =
    static_cast<std::size_t>(kPackRows + kPackCols + 64) * kPackDepth;

/// The fastest table that this processor can run; chosen at the first call.
const KernelTable& kernels();

/// Makes kernels() return the baseline table from now on; its results are the same everywhere, because it has no fused
/// multiply-add.
void useBaselineKernels(bool isAsked);
bool areBaselineKernelsUsed();

/// Kernels in ISO C++ only, with bit for bit the same results as the baseline; null in WebAssembly, where every
/// compiler has vectors.
const KernelTable* plainKernels();
/// The table of each build, null where this program was compiled without that instruction set. Only
/// `kernels` knows whether the processor has it. With HGP_PORTABLE the baseline is the plain one.
const KernelTable* baselineKernels();
const KernelTable* avx2Kernels();
const KernelTable* avx512Kernels();

/// All tables that can be run here, slowest first; for tests and benchmarks.
inline constexpr int kMaxTables = 4;
int runnableKernels(const KernelTable* tables[kMaxTables]);

}  // namespace hgp::linalg
