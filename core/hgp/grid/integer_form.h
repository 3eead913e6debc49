// A quadratic form over Z[i]ᵏ in a reduced basis.  Role: choosing the integers of a grid is a closest-vector problem.
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "hgp/base/ids.h"
#include "hgp/seams/gaussian.h"

namespace hgp {

/// Q(y) = yᴴ S y, S Hermitian and positive definite, over y = U w with U unimodular over Z[i], reduced pair by
/// pair: subtracting a Gaussian multiple of one basis vector from another does not lower Q. A
/// unit step of one w is then a local change, which moves few cones.
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
  /// Babai's nearest plane: rounds the components of w one by one, largest pivot first, each time moving those not
  /// rounded yet to their conditional minimum.
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
