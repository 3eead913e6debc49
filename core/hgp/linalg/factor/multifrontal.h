// Supernodal multifrontal Cholesky, real and complex.  Role: Laplacians (many right-hand sides),
// connection Laplacians (inverse iteration), anything positive definite.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <memory>

#include "hgp/linalg/factor/factor_status.h"
#include "hgp/linalg/factor/panel_factor.h"
#include "hgp/linalg/factor/symbolic.h"
#include "hgp/linalg/ordering/ordering.h"

namespace hgp::linalg {

/// A = L Lᴴ for Scalar = double (symmetric) or std::complex<double> (Hermitian), A positive definite.
///
///   MultifrontalCholesky<double> laplacian;
///   laplacian.analyze(graphOf(A), tree);        // once per pattern
///   if (!laplacian.factor(A)) …                 // once per set of numbers
///   X = laplacian.solve(B);                     // n × k, any k
template <class Scalar>
class MultifrontalCholesky {
 public:
  using Sparse = Eigen::SparseMatrix<Scalar>;
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

  /// Fixes the elimination. `tree` orders exactly the unknowns of `pattern`.
  void analyze(const Graph& pattern, const SeparatorTree& tree);

  /// Factors A, stored in full (both triangles; only one of each mirrored pair is read), its
  /// pattern within the analyzed one. On a bad pivot the factor is empty and the status names the
  /// unknown; `shift` is added to the diagonal first (inverse iteration).
  FactorStatus factor(const Sparse& A, double shift = 0.0);

  /// A⁻¹ B, B of n rows. Only after a successful factor (HGP_CHECK).
  Matrix solve(const Matrix& B) const;

  bool isFactored() const { return panels_.isReady(); }
  /// Flop and memory counts; valid after analyze.
  FactorCost cost() const { return factorCost(*symbolic_); }
  const SymbolicFactor& symbolic() const { return *symbolic_; }

 private:
  std::shared_ptr<const SymbolicFactor> symbolic_;
  PanelFactor<Scalar> panels_;
};

extern template class MultifrontalCholesky<double>;
extern template class MultifrontalCholesky<std::complex<double>>;

}  // namespace hgp::linalg
