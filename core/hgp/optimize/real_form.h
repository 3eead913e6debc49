// A sparse real quadratic form with small changing blocks.  Role: the linear algebra of programs over real unknowns
// (straight_program.h).
#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "hgp/linalg/factor/factor.h"
#include "hgp/socp/problem.h"

namespace hgp {

/// H over the real unknowns of n/2 pairs. A block's columns that are 0 throughout (the other half of a pair) are left out of
/// the factor. Unknowns that no block reaches are eliminated once; the program is that of the others, with vectors
/// that are 0 at these.
class RealForm : public linalg::ChangingForm {
 public:
  /// @param H            n × n, n even, symmetric, both triangles; must outlive this
  /// @param tree         orders the unknowns
  /// @param constraints  one block each
  RealForm(const Eigen::SparseMatrix<double>& H, const linalg::SeparatorTree& tree,
           const std::vector<socp::ConeConstraint>& constraints);

  /// Whether the unknowns that no block reaches could be eliminated.
  bool isFactored() const { return factor_.isBuilt(); }
  /// Of factorizations: the first, and this many after it.
  double multiplyAdds(int factorizations) const;

  /// The linear term of the program, from that of all unknowns.
  Eigen::VectorXd reduceLinear(const Eigen::VectorXd& c) const { return factor_.reduceLinear(c); }
  /// All unknowns, from the solution of the program and the linear term of all.
  Eigen::VectorXd extend(const Eigen::VectorXd& x, const Eigen::VectorXd& c) const {
    return factor_.extend(x, c);
  }

  Eigen::VectorXd apply(const Eigen::VectorXd& x) const override { return factor_.apply(x); }
  linalg::FactorStatus factor(const double* values) override;
  std::size_t blockOffset(int b) const override { return offset_[static_cast<std::size_t>(b)]; }
  std::size_t blockStorage() const override { return offset_.back(); }
  Eigen::VectorXd solve(const Eigen::VectorXd& rhs) const override { return factor_.solve(rhs); }

 private:
  using Sparse = Eigen::SparseMatrix<double>;
  struct Term {
    std::size_t target;  ///< index into the values of blocks_
    std::size_t source;  ///< index into the blocks' values
  };

  void layOut(const std::vector<socp::ConeConstraint>& constraints);

  Sparse blocks_;
  std::vector<std::size_t> offset_{0};
  std::vector<Term> terms_;
  linalg::RealPartialCholesky factor_;
};

}  // namespace hgp
