// A sparse real quadratic form with small changing blocks, factored as a whole.  Role: the linear algebra of programs
// over real unknowns (straight_program.h).
#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "hgp/linalg/factor/factor.h"

namespace hgp {

/// H over n real unknowns in the pairs that ChangingForm requires: an odd n is padded by an unknown that is 0. A
/// block's columns that are 0 throughout (the other half of a pair) are left out of the factor.
class RealForm : public linalg::ChangingForm {
 public:
  /// @param H      n × n, symmetric, both triangles
  /// @param tree   orders the unknowns
  /// @param pairs  per block, its pairs in order
  /// @param used   per block, whether each of its columns may be other than 0
  RealForm(const Eigen::SparseMatrix<double>& H, const linalg::SeparatorTree& tree,
           std::vector<std::vector<int>> pairs, const std::vector<std::vector<char>>& used);

  int size() const { return static_cast<int>(H_.cols()); }
  double multiplyAdds() const { return factor_.cost().multiplyAdds; }  ///< of one factorization

  Eigen::VectorXd apply(const Eigen::VectorXd& x) const override;
  linalg::FactorStatus factor(const double* values) override;
  std::size_t blockOffset(int b) const override { return offset_[static_cast<std::size_t>(b)]; }
  std::size_t blockStorage() const override { return offset_.back(); }
  Eigen::VectorXd solve(const Eigen::VectorXd& rhs) const override;

 private:
  struct Term {
    std::size_t target;  ///< index into the values of K_
    std::size_t source;  ///< index into the blocks' values
  };

  void layOut(std::vector<std::vector<int>> pairs, const std::vector<std::vector<char>>& used);

  Eigen::SparseMatrix<double> H_, K_;
  std::vector<std::size_t> offset_{0};
  std::vector<Term> terms_;
  linalg::MultifrontalCholesky<double> factor_;
};

}  // namespace hgp
