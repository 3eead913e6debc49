// A quadratic form that changes by small blocks.  Role: what the interior-point method needs of the linear algebra.
#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "hgp/linalg/factor/factor_status.h"

namespace hgp::linalg {

/// H + Σ_b E_bᵀ D_b E_b over pairs of real unknowns: pair j is x[2j], x[2j + 1].
class ChangingForm {
 public:
  virtual ~ChangingForm() = default;

  /// H x
  virtual Eigen::VectorXd apply(const Eigen::VectorXd& x) const = 0;
  /// Factors H + Σ blocks; block b is the column-major square at values[blockOffset(b)], symmetric positive
  /// semidefinite.
  virtual FactorStatus factor(const double* values) = 0;
  virtual std::size_t blockOffset(int b) const = 0;
  virtual std::size_t blockStorage() const = 0;  ///< doubles in all blocks
  /// (H + Σ blocks)⁻¹ rhs for the last good factor.
  virtual Eigen::VectorXd solve(const Eigen::VectorXd& rhs) const = 0;
};

}  // namespace hgp::linalg
