// A quadratic form over Z[i]ᵏ in a basis that suits it.  Role: the closest-vector problem that choosing
// integers is.
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "hgp/grid/gaussian.h"

namespace hgp {

/// Q(y) = yᴴ S y, S Hermitian and positive definite, over y = U w with U unimodular over Z[i], reduced pair by
/// pair: no basis vector becomes shorter by a Gaussian multiple of another, shorter in the sense of Q. So a
/// unit step of one w is a change that few cones see.
class IntegerForm {
 public:
  using Terms = std::vector<std::pair<int, Complex>>;

  explicit IntegerForm(Eigen::MatrixXcd S);

  Eigen::Index size() const { return S_.rows(); }
  /// Over w: Uᴴ S U.
  const Eigen::MatrixXcd& matrix() const { return S_; }

  Eigen::VectorXcd toReduced(Eigen::VectorXcd y) const;
  std::vector<Gaussian> toOriginal(std::vector<Gaussian> w) const;
  /// Σ factor · y as Σ factor · w.
  Terms toReduced(const Terms& linear) const;

  /// S⁻¹ G over w.
  Eigen::MatrixXcd solve(const Eigen::MatrixXcd& G) const;
  /// Integers near w: rounded one after the other, each time with those not rounded yet moved to their conditional
  /// minimum; first those that the form holds tightest.
  std::vector<Gaussian> rounded(const Eigen::VectorXcd& w) const;

 private:
  /// Basis vector `changed` less `factor` times basis vector `by`.
  struct Step {
    Eigen::Index changed, by;
    Gaussian factor;
  };
  void reduce();
  void factor();

  Eigen::MatrixXcd S_;
  std::vector<Step> steps_;
  std::vector<Eigen::Index> order_;  ///< of the Cholesky factor, rounded from its end
  Eigen::MatrixXcd L_;
};

}  // namespace hgp
