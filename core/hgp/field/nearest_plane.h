// Rounds a vector to a lattice in a given metric.  Role: chooses the multiples of 2π/q of the handles.
#pragma once

#include <Eigen/Core>

namespace hgp {

/// Babai's nearest plane in the metric M⁻¹, M symmetric positive definite.
class NearestPlane {
 public:
  NearestPlane() = default;
  explicit NearestPlane(const Eigen::MatrixXd& M);
  /// offset + step∘n for integers n that nearly minimise xᵀ M⁻¹ x.
  Eigen::VectorXd round(const Eigen::VectorXd& offset, const Eigen::VectorXd& step) const;
  /// M⁻¹ x
  Eigen::VectorXd solve(const Eigen::VectorXd& x) const { return U_.transpose() * (U_ * x); }

 private:
  Eigen::MatrixXd U_;  ///< upper triangular, M⁻¹ = UᵀU
};

}  // namespace hgp
