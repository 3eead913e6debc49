// Integers near given numbers that keep inequalities.  Role: which grid lines the features of a map go to.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <utility>
#include <vector>

namespace hgp {

/// Σ factor · y ≥ least.
struct LineDemand {
  std::vector<std::pair<int, double>> terms;
  double least = 1.0;
};

/// Minimises (y − y₀)ᵀ C⁻¹ (y − y₀), nearly, over integers y that fulfil all demands.
class LineChoice {
 public:
  /// @param covariance  C, symmetric and positive definite
  LineChoice(Eigen::MatrixXd covariance, std::vector<LineDemand> demands);

  /// Moves y₀ to the nearest point that fulfils the demands, by Hildreth's method; rounds one number after another, nearest
  /// first, and moves the others to their conditional minimum and back behind demands that this has broken; steps by ±1
  /// then repair what is still broken, and push what they press on. Deterministic.
  /// @param work  multiply-adds that are left, from which those that were done are taken; at 0 and below nothing is returned
  std::optional<Eigen::VectorXd> near(const Eigen::VectorXd& y0, double& work) const;

  /// Broken demands.
  int broken(const Eigen::VectorXd& y) const;

 private:
  double valueOf(const LineDemand& demand, const Eigen::VectorXd& y) const;
  void spread(Eigen::VectorXd& y, Eigen::MatrixXd& C, double& work) const;
  double roundedAt(Eigen::Index j, Eigen::VectorXd& y, const std::vector<char>& isFixed) const;
  void moveBack(const Eigen::MatrixXd& C, const std::vector<char>& isFixed, Eigen::VectorXd& y,
                double& work) const;
  double missing(const LineDemand& demand, const Eigen::VectorXd& y) const;
  double missing(const Eigen::VectorXd& y) const;
  void push(Eigen::Index j, double unit, Eigen::VectorXd& y) const;
  void repair(Eigen::VectorXd& y, double& work) const;

  Eigen::MatrixXd C_;
  std::vector<LineDemand> demands_;
  std::vector<std::vector<int>> users_;  ///< per number: demands with it
  double termCount_ = 0.0;               ///< of all demands
};

}  // namespace hgp
