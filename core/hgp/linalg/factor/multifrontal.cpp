#include "hgp/linalg/factor/multifrontal.h"

#include "hgp/base/check.h"
#include "hgp/base/portable_math.h"

namespace hgp::linalg {
namespace {

// Scatters the stored columns of A, read through the elimination order.
template <class Scalar>
FrontSource<Scalar> matrixSource(const Eigen::SparseMatrix<Scalar>& A, const SymbolicFactor& f,
                                 double shift) {
  FrontSource<Scalar> source;
  source.addToPanel = [&A, &f, shift](int t, const int* local, Scalar* panel, int rows) {
    for (int k = f.nodeStart[t]; k < f.nodeStart[t + 1]; ++k) {
      Scalar* column = panel + static_cast<std::size_t>(k - f.nodeStart[t]) * rows;
      for (typename Eigen::SparseMatrix<Scalar>::InnerIterator it(A, f.order[k]); it; ++it) {
        const int p = f.position[it.row()];
        if (p >= k) column[local[p]] += it.value();
      }
      column[local[k]] += shift;
    }
  };
  return source;
}

}  // namespace

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
  FactorStatus status =
      panels_.eliminate(matrixSource<Scalar>(A, *symbolic_, shift), diagonal, nullptr);
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
