// The linear systems of an interior-point iteration.  Role: factors H + Fᵀ M F and computes the steps of
// x, s and y from its solutions.
#pragma once

#include "hgp/socp/iterate.h"

namespace hgp::socp {

class NewtonSystem {
 public:
  explicit NewtonSystem(const Problem& problem) : problem_(problem) {}

  /// Factors H + ρ Fᵀ F; ρ = 0 is the objective alone. False where that fails.
  bool factorUniform(double rho);
  /// Factors H + Fᵀ W⁻² F at the Nesterov–Todd scaling of this point. False where that fails.
  bool factorScaled(const Iterate& point);

  /// The last factored matrix's inverse times rhs.
  Eigen::VectorXd solve(const Eigen::VectorXd& rhs) const { return problem_.form->solve(rhs); }

  /// After factorScaled(): the step that changes the scaled complementarity by `target` and reduces the
  /// residuals by the fraction `share`.
  Iterate step(const Slacks& target, const Residuals& residuals, double share) const;
  /// −λ ∘ λ: the affine scaling direction.
  Slacks predictorTarget() const;
  /// Adds the second-order term of the predictor and the centring σμ.
  void correct(Slacks& target, const Iterate& predictor, double centring) const;

 private:
  template <class RootOf>
  bool factorShared(const RootOf& rootOf);
  template <class MetricOf>
  bool factorWith(const MetricOf& metricOf);

  const Problem& problem_;
  std::vector<Scaling> scaling_;
  std::vector<double> values_;
};

}  // namespace hgp::socp
