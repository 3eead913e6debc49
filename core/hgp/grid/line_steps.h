// Unit steps of integers towards inequalities and down a quadratic form.  Role: mends what rounding has broken.
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "hgp/grid/integer_form.h"

namespace hgp {

/// Rounding errors of a demand.
inline constexpr double kLineZero = 1e-6;

/// Σ factor · y ≥ least.
struct LineDemand {
  std::vector<std::pair<int, double>> terms;
  double least = 1.0;

  double valueAt(const Eigen::VectorXd& y) const;
  /// What is missing at y, 0 where the demand is fulfilled.
  double missingAt(const Eigen::VectorXd& y) const;
};

/// Of real Gaussian integers.
Eigen::VectorXd realParts(const std::vector<Gaussian>& y);

/// Steps by ±1 of the numbers of a reduced basis of Q(y) = yᵀ S y, each of which moves few lines.
class LineSteps {
 public:
  LineSteps(const Eigen::MatrixXd& S, const std::vector<LineDemand>& demands);

  /// Steps from the integers y until all demands are fulfilled, each the one that lowers the weighted sum of what is missing
  /// most (of these, the one with the least Q(y − y₀)); where none does, what is missing gains weight: the *feasibility
  /// jump* of Luteberget and Sartor (2022). Then steps that lower Q and break nothing. Where that does not succeed, what is
  /// returned breaks the fewest demands that were seen.
  Eigen::VectorXd mended(const Eigen::VectorXd& y0, const Eigen::VectorXd& y, double& work) const;

 private:
  struct State;
  struct Step {
    Eigen::Index number = -1;
    double unit = 0.0;
  };
  double scoreOf(const State& state, const Step& step) const;
  double changeOf(const State& state, const Step& step) const;
  Step bestFor(const State& state, const std::vector<int>& broken, int turn, double& work) const;
  void take(State& state, const Step& step, double& work) const;
  std::vector<int> brokenAt(const State& state) const;
  bool mend(State& state, double& work) const;
  void descend(State& state, double& work) const;

  IntegerForm form_;
  std::vector<LineDemand> demands_;                         ///< in the reduced basis
  std::vector<std::vector<std::pair<int, double>>> users_;  ///< per number: demands and factors
};

}  // namespace hgp
