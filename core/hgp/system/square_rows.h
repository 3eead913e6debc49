// A sum of squares of sparse rows.  Role: objectives of programs as H and c, collected row by row.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
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
    terms_.reserve(expectedTerms);
  }

  /// Terms of one row with the same unknown are added.
  void add(int unknown, const Scalar& value) { terms_.emplace_back(count_, unknown, value); }
  void endRow(const Scalar& constant = 0.0) {
    for (; done_ < terms_.size(); ++done_)
      linear[terms_[done_].col()] += Eigen::numext::conj(terms_[done_].value()) * constant;
    ++count_;
  }
  /// H. The rows are freed before it is returned.
  Form takeForm() {
    Form rows(count_, linear.size());
    rows.setFromTriplets(terms_.begin(), terms_.end());
    terms_ = {};
    return rows.adjoint() * rows;
  }

  Vector linear;  ///< c

 private:
  std::vector<Eigen::Triplet<Scalar>> terms_;
  std::size_t done_ = 0;
  int count_ = 0;
};

}  // namespace hgp
