#include "hgp/grid/line_choice.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace hgp {
namespace {

constexpr int kLineSweeps = 400;
/// Hildreth's method ends where no demand moves more than this.
constexpr double kSettled = 1e-3;
/// Variances below this share of those of their terms are rounding errors.
constexpr double kNoise = 1e-10;
/// Roundings, each with more room for what the last one broke.
constexpr int kRoundings = 5;
/// Stiffness of a demand that holds with equality, in units of its own, and its growth where it is broken all the same.
constexpr double kTied = 10.0, kStiffer = 3.0;
/// Room that is added to a broken demand, at most.
constexpr double kMoreRoom = 1.0;
/// Multiply-adds of the reduction and factorization of a form over n numbers, divided by n³, in complex numbers.
constexpr double kReductionWork = 2.0;

Eigen::MatrixXd inverseOf(const Eigen::MatrixXd& C) {
  const Eigen::MatrixXd shifted = C + Eigen::MatrixXd(kNoise * C.diagonal().asDiagonal());
  return shifted.ldlt().solve(Eigen::MatrixXd::Identity(C.rows(), C.cols()));
}

}  // namespace

LineChoice::LineChoice(Eigen::MatrixXd covariance, std::vector<LineDemand> demands)
    : C_(std::move(covariance)),
      S_(inverseOf(C_)),
      demands_(std::move(demands)),
      steps_(std::make_shared<const LineSteps>(S_, demands_)) {
  for (const LineDemand& demand : demands_) {
    double curvature = 0.0, scale = 0.0;
    for (const auto& [i, factor] : demand.terms) {
      for (const auto& [j, other] : demand.terms) curvature += factor * other * C_(i, j);
      scale += factor * factor * C_(i, i);
    }
    curvature_.push_back(curvature > kNoise * scale ? curvature : 0.0);
    termCount_ += static_cast<double>(demand.terms.size());
  }
}

int LineChoice::broken(const Eigen::VectorXd& y) const {
  return static_cast<int>(
      std::count_if(demands_.begin(), demands_.end(),
                    [&](const LineDemand& demand) { return demand.missingAt(y) > 0.0; }));
}

LineChoice LineChoice::positiveAt(const Eigen::VectorXd& y0) const {
  std::vector<LineDemand> positive;
  for (const LineDemand& demand : demands_)
    if (demand.valueAt(y0) > 0.0) positive.push_back(demand);
  return {C_, std::move(positive)};
}

LineChoice::Spread LineChoice::spread(const Eigen::VectorXd& y0, const std::vector<double>& least,
                                      double& work) const {
  const auto size = static_cast<double>(y0.size());
  Spread out{y0, std::vector<double>(demands_.size(), 0.0)};
  std::vector<Eigen::VectorXd> directions(demands_.size());
  for (int sweep = 0; sweep < kLineSweeps && work > 0.0; ++sweep) {
    double largest = 0.0;
    work -= termCount_;
    for (std::size_t n = 0; n < demands_.size(); ++n) {
      const LineDemand& demand = demands_[n];
      const double missing = least[n] - demand.valueAt(out.y);
      if (curvature_[n] == 0.0 || (missing <= 0.0 && out.dual[n] == 0.0)) continue;
      work -= size;
      if (directions[n].size() == 0) {
        directions[n] = Eigen::VectorXd::Zero(y0.size());
        for (const auto& [j, factor] : demand.terms) directions[n] += factor * C_.col(j);
        work -= size * static_cast<double>(demand.terms.size());
      }
      const double change = std::max(-out.dual[n], missing / curvature_[n]);
      out.dual[n] += change;
      out.y += change * directions[n];
      largest = std::max(largest, std::fabs(change * curvature_[n]));
    }
    if (largest < kSettled) break;
  }
  return out;
}

/// Babai's nearest plane from there, in the metric S + Σ weight · a aᵀ / aᵀ C a over the demands that hold with equality.
Eigen::VectorXd LineChoice::rounded(const Spread& from, const std::vector<double>& weight,
                                    double& work) const {
  Eigen::MatrixXd S = S_;
  for (std::size_t n = 0; n < demands_.size(); ++n) {
    if (!(from.dual[n] > 0.0)) continue;
    const double stiffness = weight[n] / curvature_[n];
    for (const auto& [i, factor] : demands_[n].terms)
      for (const auto& [j, other] : demands_[n].terms) S(i, j) += stiffness * factor * other;
  }
  const auto size = static_cast<double>(from.y.size());
  work -= kReductionWork * size * size * size;
  if (work <= 0.0) return from.y;
  const IntegerForm form(S.cast<Complex>());
  return realParts(
      form.toOriginal(form.rounded(form.toReduced(Eigen::VectorXcd(from.y.cast<Complex>())))));
}

std::optional<Eigen::VectorXd> LineChoice::near(const Eigen::VectorXd& y0, double& work) const {
  std::vector<double> least, weight(demands_.size(), kTied);
  for (const LineDemand& demand : demands_) least.push_back(demand.least);
  Eigen::VectorXd best;
  int fewest = 0;
  double lowest = 0.0;
  for (int round = 0; round < kRoundings; ++round) {
    const Eigen::VectorXd y = rounded(spread(y0, least, work), weight, work);
    if (work <= 0.0) return std::nullopt;
    const int count = broken(y);
    const double form = energy(y - y0);
    if (best.size() == 0 || count < fewest || (count == fewest && form < lowest)) {
      best = y;
      fewest = count;
      lowest = form;
    }
    if (count == 0) break;
    for (std::size_t n = 0; n < demands_.size(); ++n) {
      const double missing = demands_[n].missingAt(y);
      if (missing == 0.0) continue;
      least[n] += std::min(missing + kLineZero, kMoreRoom);
      weight[n] *= kStiffer;
    }
  }
  best = steps_->mended(y0, best, work);
  if (work <= 0.0) return std::nullopt;
  return best;
}

}  // namespace hgp
