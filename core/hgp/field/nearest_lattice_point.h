// Rounds a vector to a lattice in a given metric.  Role: chooses the multiples of 2π/q of the handles, whichever generators
// the handles are measured along.
#pragma once

#include <Eigen/Core>

namespace hgp {

/// The point of the lattice offset + step∘ℤⁿ that is nearest to 0 in the metric M⁻¹, M symmetric positive definite. It is
/// found by enumeration in a basis that is reduced [LLL82], [SE94]: unlike Babai's nearest plane, it does not depend on the
/// basis. The enumeration ends after kPoints partial sums per rounding, in case of a lattice of many dimensions, with
/// the best point until then; the first one is Babai's.
class NearestLatticePoint {
 public:
  static constexpr int kPoints = 4000;

  NearestLatticePoint() = default;
  /// @param step  positive, per coordinate
  NearestLatticePoint(const Eigen::MatrixXd& M, Eigen::VectorXd step);
  /// offset + step∘n for integers n that minimise xᵀ M⁻¹ x.
  Eigen::VectorXd round(const Eigen::VectorXd& offset) const;
  /// M⁻¹ x
  Eigen::VectorXd solve(const Eigen::VectorXd& x) const { return U_.transpose() * (U_ * x); }

 private:
  Eigen::VectorXd nearestIntegers(const Eigen::VectorXd& target) const;

  Eigen::VectorXd step_;
  Eigen::MatrixXd U_;        ///< upper triangular, M⁻¹ = UᵀU
  Eigen::MatrixXd toGiven_;  ///< coordinates in the reduced basis → integers n; unimodular
  Eigen::MatrixXd Q_, R_;    ///< U diag(step) toGiven = Q R
};

}  // namespace hgp
