// Integers near given numbers that keep inequalities.  Role: which grid lines the features of a map go to.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "hgp/grid/integer_form.h"
#include "hgp/grid/line_steps.h"

namespace hgp {

/// Minimises (y − y₀)ᵀ C⁻¹ (y − y₀), nearly, over integers y that fulfil all demands.
class LineChoice {
 public:
  /// @param covariance  C, symmetric and positive definite
  LineChoice(Eigen::MatrixXd covariance, std::vector<LineDemand> demands);

  /// Moves y₀ to the nearest point that fulfils the demands, by Hildreth's method, and rounds in a basis reduced for the
  /// metric in which those that hold with equality there are stiff. Demands that this breaks are asked for with more room, a
  /// few times; unit steps mend what the best of these roundings breaks, and then lower the form. Deterministic.
  /// @param work  multiply-adds that are left, from which those that were done are taken; at 0 and below nothing is returned
  std::optional<Eigen::VectorXd> near(const Eigen::VectorXd& y0, double& work) const;

  /// Broken demands.
  int broken(const Eigen::VectorXd& y) const;

  /// Only the demands aᵀ y ≥ least with aᵀ y₀ > 0: a multiple of y₀ fulfils all of them, so that they do not contradict each
  /// other.
  LineChoice positiveAt(const Eigen::VectorXd& y0) const;

 private:
  struct Spread {
    Eigen::VectorXd y;
    std::vector<double> dual;  ///< per demand
  };
  Spread spread(const Eigen::VectorXd& y0, const std::vector<double>& least, double& work) const;
  Eigen::VectorXd rounded(const Spread& from, const std::vector<double>& weight,
                          double& work) const;
  double energy(const Eigen::VectorXd& change) const { return change.dot(S_ * change); }

  Eigen::MatrixXd C_, S_;  ///< S = C⁻¹
  std::vector<LineDemand> demands_;
  std::vector<double> curvature_;  ///< aᵀ C a per demand aᵀ y ≥ least
  double termCount_ = 0.0;         ///< of all demands
  std::shared_ptr<const LineSteps> steps_;
};

}  // namespace hgp
