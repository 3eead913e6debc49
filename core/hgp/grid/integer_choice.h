// Integers near a minimiser of a quadratic form.  Role: which grid points the translations of a map go
// to, kept apart where cones are neighbours.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>

#include "hgp/grid/integer_form.h"

namespace hgp {

/// A linear function of y that must stay near its direction and away from 0: the path from a cone to a
/// neighbour. With a second function, the rotation from the first to the second must stay counterclockwise instead.
struct Separation {
  IntegerForm::Terms terms, second = {};
};

/// Q(y) = (y − y₀)ᴴ S (y − y₀) over y ∈ Z[i]ᵏ, S Hermitian and positive definite. For one thread at a time: near() keeps
/// what does not depend on y₀.
class IntegerChoice {
 public:
  IntegerChoice(std::shared_ptr<const IntegerForm> form, std::vector<Separation> separations);

  /// Changes y₀ as little as separations of two cones require, rounds it, and then takes single steps ±1, ±i of the
  /// reduced basis while they correct separations (violated: D = 0, or more than 72° from its direction at
  /// y₀; not counterclockwise) or lower Q. Deterministic.
  std::vector<Gaussian> near(const Eigen::VectorXcd& y0) const;

  /// Violated separations of two cones only: with two cones on one point there is a fold on any patch.
  int wrongPairs(const Eigen::VectorXcd& y0, const std::vector<Gaussian>& y) const;
  int wrongSeparations(const Eigen::VectorXcd& y0, const std::vector<Gaussian>& y) const;
  double energy(const Eigen::VectorXcd& y0, const std::vector<Gaussian>& y) const;

 private:
  struct Use {
    int separation;
    Complex factor, second;
  };
  Eigen::VectorXcd spread(const Eigen::VectorXcd& w0) const;
  void descend(const Eigen::VectorXcd& w0, std::vector<Gaussian>& w) const;

  std::shared_ptr<const IntegerForm> form_;
  std::vector<Separation> separations_;              ///< in the reduced basis
  std::vector<std::vector<Use>> users_;              ///< per w: separations with it
  mutable std::optional<Eigen::MatrixXcd> inverse_;  ///< S⁻¹ over w, once it is needed
};

}  // namespace hgp
