// Unknowns that SchurLu eliminated, from the kept ones.  Role: a program reads the few of its frames.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "hgp/linalg/factor/schur_lu.h"

namespace hgp::linalg {

/// Rows of x with x_k given and A_ee x_e = −A_ek x_k. Only the part of the tree above the unknowns asked for is visited,
/// each node once: its values are kept for the next call.
class SchurExtension {
 public:
  /// @param lu     must outlive this
  /// @param xKept  lu's kept unknowns × any columns
  SchurExtension(const SchurLu& lu, const Eigen::MatrixXcd& xKept);

  /// unknowns.size() × columns, in their order.
  Eigen::MatrixXcd rows(const std::vector<int>& unknowns);

 private:
  using Complex = std::complex<double>;
  // By rows, since a node reads single rows of its ancestors.
  using Rows = Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  std::vector<char> newNodes(const std::vector<int>& unknowns) const;
  void addRows(const std::vector<char>& isNew);
  void backward(int t);

  const SchurLu::State& lu_;
  Eigen::Index columns_;
  std::vector<Rows> blocks_;   // what each call added
  std::vector<Complex*> row_;  // position → values, nullptr
};

}  // namespace hgp::linalg
