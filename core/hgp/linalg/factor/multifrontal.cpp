#include "hgp/linalg/factor/multifrontal.h"

#include "hgp/base/check.h"
#include "hgp/base/portable_math.h"
#include "hgp/linalg/factor/matrix_source.h"

namespace hgp::linalg {
template <class Scalar>
void MultifrontalCholesky<Scalar>::analyze(const Graph& pattern, const SeparatorTree& tree) {
  symbolic_ = std::make_shared<const SymbolicFactor>(linalg::analyze(pattern, tree.order));
  panels_.layOut(symbolic_);
}

template <class Scalar>
FactorStatus MultifrontalCholesky<Scalar>::factor(const Sparse& A, double shift) {
  HGP_CHECK(symbolic_ != nullptr && A.rows() == symbolic_->size() && A.cols() == symbolic_->size(),
            "matrix %d × %d was not analyzed", static_cast<int>(A.rows()),
            static_cast<int>(A.cols()));
  std::vector<double> diagonal(static_cast<std::size_t>(A.rows()));
  for (int k = 0; k < A.rows(); ++k) {
    const int v = symbolic_->order[k];
    diagonal[k] = portable::abs(A.coeff(v, v)) + portable::abs(shift);
  }
  FactorStatus status = panels_.eliminate(matrixSource(A, *symbolic_, shift), diagonal, nullptr);
  if (!status) status.badPivot = symbolic_->order[status.badPivot];
  return status;
}

template <class Scalar>
auto MultifrontalCholesky<Scalar>::solve(const Matrix& B) const -> Matrix {
  HGP_CHECK(isFactored(), "solve without a factor of %d unknowns", static_cast<int>(B.rows()));
  HGP_CHECK(B.rows() == symbolic_->size(), "%d rows for %d unknowns", static_cast<int>(B.rows()),
            symbolic_->size());
  Matrix x(B.rows(), B.cols());
  for (int c = 0; c < B.cols(); ++c)
    for (int k = 0; k < B.rows(); ++k) x(k, c) = B(symbolic_->order[k], c);
  panels_.forward(x);
  panels_.backward(x);
  Matrix result(B.rows(), B.cols());
  for (int c = 0; c < B.cols(); ++c)
    for (int k = 0; k < B.rows(); ++k) result(symbolic_->order[k], c) = x(k, c);
  return result;
}

template class MultifrontalCholesky<double>;
template class MultifrontalCholesky<std::complex<double>>;

}  // namespace hgp::linalg
