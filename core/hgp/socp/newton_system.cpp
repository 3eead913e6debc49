#include "hgp/socp/newton_system.h"

#include <cmath>

#include "hgp/linalg/factor/times_adjoint.h"

namespace hgp::socp {

/// H + Σ (R_b F_b)ᵀ R_b F_b with the given symmetric 3 × 3 roots R_b of the metrics, as one dense block.
template <class RootOf>
bool NewtonSystem::factorShared(const RootOf& rootOf) {
  const auto& constraints = problem_.constraints;
  const Eigen::Index size = constraints.front().F.cols();
  Eigen::MatrixXd scaled(size, 3 * static_cast<Eigen::Index>(constraints.size()));
  for (std::size_t b = 0; b < constraints.size(); ++b)
    scaled.middleCols(3 * static_cast<Eigen::Index>(b), 3) =
        (rootOf(b) * constraints[b].F).transpose();
  values_.resize(problem_.form->blockStorage());
  Eigen::Map<Eigen::MatrixXd> block(values_.data(), size, size);
  block = linalg::timesAdjoint(scaled);
  block = Eigen::MatrixXd(block.selfadjointView<Eigen::Lower>());
  return static_cast<bool>(problem_.form->factor(values_.data()));
}

/// H + Σ F_bᵀ M_b F_b with the given 3 × 3 metrics.
template <class MetricOf>
bool NewtonSystem::factorWith(const MetricOf& metricOf) {
  values_.resize(problem_.form->blockStorage());
  for (std::size_t b = 0; b < problem_.constraints.size(); ++b) {
    const auto& F = problem_.constraints[b].F;
    Eigen::Map<Eigen::MatrixXd> block(
        values_.data() + problem_.form->blockOffset(static_cast<int>(b)), F.cols(), F.cols());
    block.noalias() = F.transpose() * metricOf(b) * F;
  }
  return static_cast<bool>(problem_.form->factor(values_.data()));
}

bool NewtonSystem::factorUniform(double rho) {
  if (problem_.sharesBlock)
    return factorShared(
        [rho](std::size_t) -> Matrix3 { return std::sqrt(rho) * Matrix3::Identity(); });
  return factorWith([rho](std::size_t) -> Matrix3 { return rho * Matrix3::Identity(); });
}

bool NewtonSystem::factorScaled(const Iterate& point) {
  scaling_.resize(point.s.size());
  for (std::size_t b = 0; b < scaling_.size(); ++b) {
    scaling_[b] = ntScaling(point.s[b], point.y[b]);
    if (!scaling_[b].inverse.allFinite()) return false;
  }
  if (problem_.sharesBlock)
    return factorShared([&](std::size_t b) -> Matrix3 { return scaling_[b].inverse; });
  return factorWith(
      [&](std::size_t b) -> Matrix3 { return scaling_[b].inverse * scaling_[b].inverse; });
}

Slacks NewtonSystem::predictorTarget() const {
  Slacks target(scaling_.size());
  for (std::size_t b = 0; b < target.size(); ++b)
    target[b] = -product(scaling_[b].lambda, scaling_[b].lambda);
  return target;
}

void NewtonSystem::correct(Slacks& target, const Iterate& predictor, double centring) const {
  for (std::size_t b = 0; b < target.size(); ++b) {
    target[b] -= product(scaling_[b].inverse * predictor.s[b], scaling_[b].W * predictor.y[b]);
    target[b][0] += centring;
  }
}

Iterate NewtonSystem::step(const Slacks& target, const Residuals& residuals, double share) const {
  Iterate step;
  Eigen::VectorXd rhs = -share * residuals.x;
  Slacks shift(target.size());
  for (std::size_t b = 0; b < target.size(); ++b) {
    // W⁻ᵀds + W dy = λ⋄target and ds = F dx − share·r_s give
    // dy = W⁻²(W(λ⋄target) + share·r_s − F dx).
    const Matrix3& inverse = scaling_[b].inverse;
    shift[b] =
        inverse * (divide(scaling_[b].lambda, target[b]) + inverse * (share * residuals.s[b]));
    addTransposed(problem_.constraints[b], shift[b], 1.0, rhs);
  }
  step.x = solve(rhs);
  step.s.resize(target.size());
  step.y.resize(target.size());
  for (std::size_t b = 0; b < target.size(); ++b) {
    const Vector3 moved = image(problem_.constraints[b], step.x);
    step.s[b] = moved - share * residuals.s[b];
    step.y[b] = shift[b] - scaling_[b].inverse * (scaling_[b].inverse * moved);
  }
  return step;
}

}  // namespace hgp::socp
