// Integers near a minimiser of a quadratic form.  Role: which grid points the translations of a map go
// to, kept apart where cones are neighbours.
#pragma once

#include <Eigen/Core>

#include "hgp/grid/gaussian.h"

namespace hgp {

/// A linear function of y that must stay near its direction and away from 0.
struct Separation {
  std::vector<std::pair<int, Complex>> terms;
};

/// Q(y) = (y − y₀)ᴴ S (y − y₀) over y ∈ Z[i]ᵏ, S Hermitian and positive definite.
class IntegerChoice {
 public:
  IntegerChoice(Eigen::MatrixXcd S, std::vector<Separation> separations);
  void setSeparations(std::vector<Separation> separations);

  /// Rounded nearest first, each time with the others moved to their conditional minimum; then single
  /// steps ±1, ±i while they correct separations (wrong: D = 0, or more than 72° from where y₀ has it) or
  /// lower Q. Deterministic.
  std::vector<Gaussian> near(const Eigen::VectorXcd& y0) const;

  int wrongSeparations(const Eigen::VectorXcd& y0, const std::vector<Gaussian>& y) const;
  double energy(const Eigen::VectorXcd& y0, const std::vector<Gaussian>& y) const;

 private:
  std::vector<Gaussian> rounded(const Eigen::VectorXcd& y0) const;
  void descend(const Eigen::VectorXcd& y0, std::vector<Gaussian>& y) const;

  Eigen::MatrixXcd S_, covariance_;
  std::vector<Separation> separations_;
  std::vector<std::vector<std::pair<int, Complex>>> users_;  ///< per y: separations with it
};

}  // namespace hgp
