// Elimination of complex rows down to a dense Schur complement.  Role: harmonic rows that hold
// exactly; the remaining problem has only the few kept unknowns.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <complex>
#include <functional>
#include <memory>
#include <vector>

#include "hgp/linalg/factor/factor_status.h"
#include "hgp/linalg/factor/symbolic.h"
#include "hgp/linalg/ordering/ordering.h"

namespace hgp::linalg {

/// xᴴ H x + 2 Re(cᴴ x).
struct QuadraticForm {
  Eigen::MatrixXcd H;  ///< Hermitian, in full
  Eigen::VectorXcd c;
};

/// A quadratic form given as a sum of small ones. The unknowns of an element must be neighbours in the pattern of A, or
/// kept.
struct FormElements {
  struct Element {
    std::vector<int> unknowns;  ///< distinct
    Eigen::MatrixXcd H;         ///< its lower triangle is read
    Eigen::VectorXcd c;
  };
  int count = 0;
  std::function<void(int element, std::vector<int>& unknowns)> unknownsOf;
  /// Reuses the memory of `out`; called by several threads, each with its own.
  std::function<void(int element, Element& out)> get;
};

/// With the unknowns split into eliminated e and kept k,
///
///   A_ee x_e + A_ek x_k = 0 exactly,     S x_k = (A x)_k = (A_kk − A_ke A_ee⁻¹ A_ek) x_k.
///
/// Multifrontal LU without pivoting, for rows that are weakly diagonally dominant (then no pivot
/// grows); the pattern is treated as symmetric. Only U is kept: right-hand sides are zero.
class SchurLu {
 public:
  using Complex = std::complex<double>;
  using SparseRows = Eigen::SparseMatrix<Complex, Eigen::RowMajor>;

  SchurLu();
  ~SchurLu();
  SchurLu(SchurLu&&) noexcept;
  SchurLu& operator=(SchurLu&&) noexcept;

  /// @param A     n × n; rows of kept unknowns are arbitrary and may be empty
  /// @param kept  distinct unknowns, anywhere in the tree; S is dense over them
  /// @param tree  orders the unknowns (dissect the graph of A: width 1)
  /// @return not ok with the unknown whose pivot is not above kPivotTolerance × |A_jj|
  FactorStatus build(const SparseRows& A, const std::vector<int>& kept, const SeparatorTree& tree);

  /// Estimates the cost of build(): complex multiply-adds (twice those of Cholesky) and entries.
  static FactorCost estimate(const Graph& pattern, const std::vector<int>& kept,
                             const SeparatorTree& tree);

  /// The same of the factor that was built.
  FactorCost cost() const;

  /// |kept| × |kept|, rows and columns in the order of `kept`.
  const Eigen::MatrixXcd& schur() const;
  /// Sᴴ D² S with D = diag(weight) over the kept rows; only the lower triangle is defined.
  Eigen::MatrixXcd gram(const Eigen::VectorXd& weight) const;
  /// All n unknowns from the kept ones; kept.size() × any columns. Of some unknowns: SchurExtension.
  Eigen::MatrixXcd extend(const Eigen::MatrixXcd& xKept) const;
  /// xᴴ H x + 2 Re(cᴴ x) in terms of the kept unknowns, x = extend(x_k). Costs about three times what build() did.
  QuadraticForm restrict(const FormElements& elements) const;

  struct State;  // of the files that implement this class

 private:
  friend class SchurExtension;
  std::unique_ptr<State> state_;
};

}  // namespace hgp::linalg
