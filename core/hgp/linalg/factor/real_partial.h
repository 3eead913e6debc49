// A sparse real matrix of which few columns change.  Role: the linear algebra of programs over real unknowns; each
// iteration factors only what its blocks can reach. PartialCholesky is the same for complex unknowns.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <memory>
#include <vector>

#include "hgp/linalg/factor/panel_factor.h"
#include "hgp/linalg/ordering/ordering.h"

namespace hgp::linalg {

/// K = H + (blocks on cliques), symmetric. Unknowns that no clique reaches are *static*: eliminated once. The others form the
/// reduced problem with H̃ = H_dd − H_ds H_ss⁻¹ H_sd; its vectors have all n entries, 0 at static unknowns.
class RealPartialCholesky {
 public:
  using Sparse = Eigen::SparseMatrix<double>;

  /// Eliminates the static unknowns; what is not ok fails every factor().
  /// @param H        n × n, positive semidefinite, both triangles; must outlive this
  /// @param tree     orders the unknowns
  /// @param cliques  the unknowns of each block; a block may have fewer entries than its square
  void build(const Sparse& H, const SeparatorTree& tree, const Cliques& cliques);

  bool isBuilt() const { return static_cast<bool>(staticStatus_); }

  /// The linear term of the reduced problem: c_d − H_ds H_ss⁻¹ c_s.
  Eigen::VectorXd reduceLinear(const Eigen::VectorXd& c) const;
  /// H̃ x
  Eigen::VectorXd apply(const Eigen::VectorXd& x) const;
  /// Factors the reduced part of H + blocks, where `blocks` has entries within cliques only.
  FactorStatus factor(const Sparse& blocks);
  /// Of the last good factor.
  Eigen::VectorXd solve(const Eigen::VectorXd& rhs) const;
  /// The minimiser of ½ xᵀHx + cᵀx with the entries of `reduced` at the unknowns that are not static.
  Eigen::VectorXd extend(const Eigen::VectorXd& reduced, const Eigen::VectorXd& c) const;

  FactorCost staticCost() const { return factorCost(*symbolic_, 0); }   ///< once
  FactorCost reducedCost() const { return factorCost(*symbolic_, 1); }  ///< per factor()

 private:
  Eigen::MatrixXd byPosition(const Eigen::VectorXd& x) const;
  Eigen::VectorXd reducedPart(const Eigen::MatrixXd& x) const;
  FactorStatus eliminate(const Sparse* blocks, PanelFactor<double>& panels,
                         std::vector<Contribution<double>>* left) const;

  std::shared_ptr<const SymbolicFactor> symbolic_;
  std::vector<char> isReduced_;  ///< by position
  const Sparse* H_ = nullptr;
  std::vector<double> diagonal_;  ///< of H, absolute values by position
  FactorStatus staticStatus_;
  PanelFactor<double> statics_, reduced_;
  std::vector<Contribution<double>> complements_;  ///< by node; of static ones below reduced ones
};

}  // namespace hgp::linalg
