// A sum of squares of sparse rows.  Role: objectives of programs as H and c, collected row by row.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <complex>
#include <vector>

namespace hgp {

/// Σ |row·x + constant|² = xᴴ H x + 2 Re(cᴴ x) + const over n unknowns, real or complex.
template <class Scalar>
class SquareRows {
 public:
  using Form = Eigen::SparseMatrix<Scalar>;
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

  explicit SquareRows(int unknowns, std::size_t expectedTerms = 0)
      : linear(Vector::Zero(unknowns)) {
    unknown_.reserve(expectedTerms);
    factor_.reserve(expectedTerms);
  }

  /// Terms of one row with the same unknown are added.
  void add(int unknown, const Scalar& value) {
    unknown_.push_back(unknown);
    factor_.push_back(value);
  }
  void endRow(const Scalar& constant = 0.0) {
    for (auto i = static_cast<std::size_t>(start_.back()); i < unknown_.size(); ++i)
      linear[unknown_[i]] += Eigen::numext::conj(factor_[i]) * constant;
    start_.push_back(static_cast<int>(unknown_.size()));
  }
  /// H, whose two triangles are conjugates to the last bit. The rows are freed.
  Form takeForm();

  Vector linear;  ///< c

 private:
  std::vector<int> start_{0}, unknown_;
  std::vector<Scalar> factor_;
};

extern template class SquareRows<double>;
extern template class SquareRows<std::complex<double>>;

}  // namespace hgp
