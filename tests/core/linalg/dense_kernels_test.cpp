#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <complex>

#include "hgp/linalg/kernels/kernel_workspace.h"

namespace hgp::linalg {
namespace {

std::vector<const KernelTable*> tables() {
  const KernelTable* found[kMaxTables];
  const int count = runnableKernels(found);
  return {found, found + count};
}

template <class Matrix>
double* raw(Matrix& m) {
  return reinterpret_cast<double*>(m.data());
}

/// Of the rows of b, which may be fewer than those of a.
template <class Matrix>
double lowerError(const Matrix& a, const Matrix& b, bool lower) {
  double error = 0;
  for (int j = 0; j < b.cols(); ++j)
    for (int i = lower ? j : 0; i < b.rows(); ++i)
      error = std::max(error, std::abs(a(i, j) - b(i, j)));
  return error;
}

double times(double a, double b) { return a * b; }
/// As written, without the case of infinities: a product of std::complex is a call.
std::complex<double> times(std::complex<double> a, std::complex<double> b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}
double conjugate(double a) { return a; }
std::complex<double> conjugate(std::complex<double> a) { return std::conj(a); }

/// A Bᴴ from the first m and n rows, or its lower triangle alone, by the definition: Eigen's takes seconds
/// to compile in every build.
template <class Matrix>
Matrix productOf(const Matrix& A, int m, const Matrix& B, int n, bool lower = false) {
  using Scalar = typename Matrix::Scalar;
  Matrix product = Matrix::Zero(m, n);
  for (int j = 0; j < n; ++j)
    for (int k = 0; k < A.cols(); ++k) {
      const Scalar b = conjugate(B.data()[k * B.rows() + j]);
      const Scalar* from = A.data() + k * A.rows();
      Scalar* to = product.data() + static_cast<Eigen::Index>(j) * m;
      for (int i = lower ? j : 0; i < m; ++i) to[i] += times(from[i], b);
    }
  return product;
}

/// The lower factor L of A = L Lᴴ, by the definition.
template <class Matrix>
Matrix choleskyOf(const Matrix& A) {
  using Scalar = typename Matrix::Scalar;
  Matrix L = Matrix::Zero(A.rows(), A.cols());
  for (int j = 0; j < A.cols(); ++j) {
    for (int i = j; i < A.rows(); ++i) {
      Scalar sum = A(i, j);
      for (int k = 0; k < j; ++k) sum -= times(L(i, k), conjugate(L(j, k)));
      L(i, j) = i == j ? Scalar(std::sqrt(std::real(sum))) : sum / std::real(L(j, j));
    }
  }
  return L;
}

/// A positive definite matrix.
template <class Matrix>
Matrix positive(int n) {
  const Matrix G = Matrix::Random(n, n);
  Matrix A = productOf<Matrix>(G, n, G, n);
  for (int i = 0; i < n; ++i) A(i, i) += n;
  return A;
}

/// Of every table, both triangles or one, added or put: the product is what takes time.
template <class Matrix>
void expectUpdatesAreTheProduct(int m, int n, int k, bool lower) {
  constexpr bool kReal = sizeof(typename Matrix::Scalar) == sizeof(double);
  const KernelWorkspace work;
  Matrix A = Matrix::Random(m + 3, k), B = Matrix::Random(n + 1, k);
  const Matrix product = productOf<Matrix>(A, m, B, n, lower);
  const Matrix start = Matrix::Random(m + 2, n);
  for (const bool overwrite : {false, true}) {
    const Matrix expected = overwrite ? Matrix(-product) : Matrix(start.topRows(m) - product);
    for (const KernelTable* table : tables()) {
      Matrix C = start;
      const KernelTable::Update task = {m,     n,     k,     raw(A), raw(B),   raw(C),
                                        m + 3, n + 1, m + 2, lower,  overwrite};
      (kReal ? table->updateReal : table->updateComplex)(task, work.data());
      EXPECT_LT(lowerError<Matrix>(C, expected, lower), 1e-12 * (1 + k))
          << table->name << " " << m << " " << n << " " << k << " " << overwrite;
    }
  }
}

template <class Matrix>
void expectPanelIsCholesky(const KernelTable& table, int rows, int pivots) {
  constexpr bool kReal = sizeof(typename Matrix::Scalar) == sizeof(double);
  const KernelWorkspace work;
  const Matrix A = positive<Matrix>(rows), L = choleskyOf<Matrix>(A);
  Matrix P = A.leftCols(pivots);
  const Eigen::VectorXd threshold = Eigen::VectorXd::Zero(pivots);
  const int bad = (kReal ? table.factorPanelReal : table.factorPanelComplex)(
      rows, pivots, raw(P), rows, threshold.data(), work.data());
  EXPECT_EQ(bad, -1);
  EXPECT_LT(lowerError<Matrix>(P, L.leftCols(pivots), true), 1e-12 * rows) << table.name;
}

TEST(DenseKernels, UpdateSubtractsTheProduct) {
  // More rows than two packs have, deeper than one, and two packs both ways.
  for (const int m : {1, 2, 5, 24, 49, 200, 2 * kPackRows + 6})
    for (const int k : {1, 3, 8, 65, kPackDepth + 4}) {
      if (m > 2 * kPackRows && k > kPackDepth) continue;
      for (const bool lower : {false, true}) {
        const int n = lower ? m : m / 2 + 3;
        expectUpdatesAreTheProduct<Eigen::MatrixXd>(m, n, k, lower);
        expectUpdatesAreTheProduct<Eigen::MatrixXcd>(m, n, k, lower);
      }
    }
}

TEST(DenseKernels, UpdateCoversMoreColumnsThanOnePack) {
  expectUpdatesAreTheProduct<Eigen::MatrixXd>(1300, 1300, 5, true);
  expectUpdatesAreTheProduct<Eigen::MatrixXcd>(700, 700, 5, true);
}

TEST(DenseKernels, PanelIsTheLeftPartOfTheCholeskyFactor) {
  for (const KernelTable* table : tables())
    for (const int pivots : {1, 2, 7, 8, 9, 16, 23, 64, 131})
      for (const int more : {0, 1, 6, 75}) {
        expectPanelIsCholesky<Eigen::MatrixXd>(*table, pivots + more, pivots);
        expectPanelIsCholesky<Eigen::MatrixXcd>(*table, pivots + more, pivots);
      }
}

TEST(DenseKernels, PanelNamesTheFirstPivotThatIsNotPositive) {
  const KernelWorkspace work;
  for (const KernelTable* table : tables())
    for (const int wrong : {0, 5, 17, 39}) {
      for (const double value : {-1.0, 0.0, std::nan("")}) {
        Eigen::MatrixXd P = Eigen::MatrixXd::Identity(50, 40);
        P(wrong, wrong) = value;
        const Eigen::VectorXd threshold = Eigen::VectorXd::Constant(40, 1e-14);
        EXPECT_EQ(table->factorPanelReal(50, 40, P.data(), 50, threshold.data(), work.data()),
                  wrong);
      }
    }
}

/// Every kernel of both tables on the same numbers.
template <class Matrix>
void expectSameBits(const KernelTable& a, const KernelTable& b, int rows, int pivots) {
  constexpr bool kReal = sizeof(typename Matrix::Scalar) == sizeof(double);
  const KernelWorkspace work;
  Matrix A = Matrix::Random(rows, pivots), B = Matrix::Random(rows, pivots);
  const Matrix C = Matrix::Random(rows, rows), G = positive<Matrix>(rows);
  const Eigen::VectorXd threshold = Eigen::VectorXd::Zero(pivots);
  Matrix products[2] = {C, C}, panels[2] = {G.leftCols(pivots), G.leftCols(pivots)};
  for (int n = 0; n < 2; ++n) {
    const KernelTable& table = n == 0 ? a : b;
    const KernelTable::Update task = {rows, rows, pivots, raw(A),        raw(B), raw(products[n]),
                                      rows, rows, rows,   rows % 2 == 0, false};
    (kReal ? table.updateReal : table.updateComplex)(task, work.data());
    const int bad = (kReal ? table.factorPanelReal : table.factorPanelComplex)(
        rows, pivots, raw(panels[n]), rows, threshold.data(), work.data());
    EXPECT_EQ(bad, -1);
  }
  EXPECT_EQ(lowerError<Matrix>(products[0], products[1], true), 0);
  EXPECT_EQ(lowerError<Matrix>(panels[0], panels[1], true), 0);
}

TEST(DenseKernels, IsoCppAndTheBaselineGiveTheSameBits) {
  if (!plainKernels()) return;  // WebAssembly
  for (const int pivots : {1, 3, 8, 21, 64})
    for (const int more : {0, 1, 6, 75}) {
      expectSameBits<Eigen::MatrixXd>(*plainKernels(), *baselineKernels(), pivots + more, pivots);
      expectSameBits<Eigen::MatrixXcd>(*plainKernels(), *baselineKernels(), pivots + more, pivots);
    }
  Eigen::MatrixXcd P = Eigen::MatrixXcd::Random(60, 30), Q = Eigen::MatrixXcd::Random(60, 30);
  P.topRows(30) += 60 * Eigen::MatrixXcd::Identity(30, 30);
  Q.topRows(30) = P.topRows(30).adjoint();
  const Eigen::VectorXd threshold = Eigen::VectorXd::Zero(30);
  const KernelWorkspace work;
  Eigen::MatrixXcd p[2] = {P, P}, q[2] = {Q, Q};
  for (int n = 0; n < 2; ++n)
    EXPECT_EQ((n == 0 ? plainKernels() : baselineKernels())
                  ->factorPanelLu(60, 30, raw(p[n]), raw(q[n]), 60, threshold.data(), work.data()),
              -1);
  EXPECT_EQ(lowerError<Eigen::MatrixXcd>(p[0], p[1], true), 0);
  EXPECT_EQ(lowerError<Eigen::MatrixXcd>(q[0], q[1], true), 0);
}

}  // namespace
}  // namespace hgp::linalg
