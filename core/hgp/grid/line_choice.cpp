#include "hgp/grid/line_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hgp/base/ids.h"

namespace hgp {
namespace {

constexpr int kLineSweeps = 400, kSweepsBetween = 10;
constexpr double kLineZero = 1e-6;
/// A demand that had to be enforced stays close to equality in the metric of the rounding.
constexpr double kTied = 1e-4;
/// Numbers with a smaller share of their variance left are determined by those that are fixed.
constexpr double kDetermined = 1e-6;
/// Variances below this share of those of their terms are rounding errors.
constexpr double kNoise = 1e-10;
/// Rounding moves no line farther: what would is determined by what is fixed, up to rounding errors.
constexpr double kLargestMove = 20.0;
/// Units of repair, and broken demands with which it is not begun.
constexpr int kRepairSteps = 60, kHopelesslyBroken = 40;

}  // namespace

LineChoice::LineChoice(Eigen::MatrixXd covariance, std::vector<LineDemand> demands)
    : C_(std::move(covariance)), demands_(std::move(demands)), users_(at(C_.rows())) {
  for (std::size_t n = 0; n < demands_.size(); ++n) {
    for (const auto& [j, factor] : demands_[n].terms) users_[at(j)].push_back(static_cast<int>(n));
    termCount_ += static_cast<double>(demands_[n].terms.size());
  }
}

double LineChoice::valueOf(const LineDemand& demand, const Eigen::VectorXd& y) const {
  double value = 0.0;
  for (const auto& [j, factor] : demand.terms) value += factor * y[j];
  return value;
}

int LineChoice::broken(const Eigen::VectorXd& y) const {
  return static_cast<int>(std::count_if(
      demands_.begin(), demands_.end(),
      [&](const LineDemand& demand) { return valueOf(demand, y) < demand.least - kLineZero; }));
}

void LineChoice::spread(Eigen::VectorXd& y, Eigen::MatrixXd& C, double& work) const {
  const auto size = static_cast<double>(y.size());
  const auto direction = [&](const LineDemand& demand) {
    Eigen::VectorXd step = Eigen::VectorXd::Zero(y.size());
    for (const auto& [j, factor] : demand.terms) step += factor * C.col(j);
    return step;
  };
  std::vector<double> dual(demands_.size(), 0.0);
  std::vector<Eigen::VectorXd> steps(demands_.size());
  for (int sweep = 0; sweep < kLineSweeps && work > 0.0; ++sweep) {
    double largest = 0.0;
    work -= termCount_;
    for (std::size_t n = 0; n < demands_.size(); ++n) {
      const LineDemand& demand = demands_[n];
      const double missing = demand.least - valueOf(demand, y);
      if (missing <= 0.0 && dual[n] == 0.0) continue;
      work -= size;
      if (steps[n].size() == 0) {
        steps[n] = direction(demand);
        work -= size * static_cast<double>(demand.terms.size());
      }
      const double curvature = valueOf(demand, steps[n]);
      double scale = 0.0;
      for (const auto& [j, factor] : demand.terms) scale += factor * factor * C_(j, j);
      if (!(curvature > kNoise * scale)) continue;
      const double change = std::max(-dual[n], missing / curvature);
      dual[n] += change;
      y += change * steps[n];
      largest = std::max(largest, std::fabs(change * curvature));
    }
    if (largest < 1e-3) break;
  }
  for (std::size_t n = 0; n < demands_.size(); ++n) {
    if (!(dual[n] > 0.0) || work <= 0.0) continue;
    work -= size * size;
    const Eigen::VectorXd step = direction(demands_[n]);
    const double curvature = valueOf(demands_[n], step);
    if (!(curvature > kDetermined * valueOf(demands_[n], steps[n]))) continue;
    C.noalias() -= step * (step / (curvature * (1.0 + kTied))).transpose();
  }
}

/// The nearest integer, or the next one on the other side where the nearest breaks a demand that nothing else can mend.
double LineChoice::roundedAt(Eigen::Index j, Eigen::VectorXd& y,
                             const std::vector<char>& isFixed) const {
  const double own = y[j], nearest = std::nearbyint(own);
  const double other = nearest > own ? nearest - 1.0 : nearest + 1.0;
  const auto lack = [&](double value) {
    double sum = 0.0;
    y[j] = value;
    for (const int n : users_[at(j)]) {
      const LineDemand& demand = demands_[at(n)];
      const bool isLast = std::all_of(demand.terms.begin(), demand.terms.end(), [&](const auto& t) {
        return t.first == j || isFixed[at(t.first)];
      });
      if (isLast) sum += missing(demand, y);
    }
    y[j] = own;
    return sum;
  };
  return lack(other) < lack(nearest) ? other : nearest;
}

/// Moves what is not fixed behind the demands that are broken, as far as that is possible.
void LineChoice::moveBack(const Eigen::MatrixXd& C, const std::vector<char>& isFixed,
                          Eigen::VectorXd& y, double& work) const {
  const auto size = static_cast<double>(y.size());
  for (int sweep = 0; sweep < kSweepsBetween; ++sweep) {
    bool isAny = false;
    work -= termCount_;
    for (const LineDemand& demand : demands_) {
      const double lack = missing(demand, y);
      if (lack <= 0.0) continue;
      work -= size * static_cast<double>(demand.terms.size() + 3);
      Eigen::VectorXd way = Eigen::VectorXd::Zero(y.size());
      double scale = 0.0;
      for (const auto& [j, factor] : demand.terms)
        if (!isFixed[at(j)]) {
          way += factor * C.col(j);
          scale += factor * factor * kDetermined * C_(j, j);
        }
      for (Eigen::Index i = 0; i < y.size(); ++i)
        if (isFixed[at(i)]) way[i] = 0.0;
      const double curvature = valueOf(demand, way);
      if (!(curvature > scale) || scale == 0.0) continue;
      way *= (lack + kLineZero) / curvature;
      if (!(way.lpNorm<Eigen::Infinity>() < kLargestMove)) continue;
      y += way;
      isAny = true;
    }
    if (!isAny) return;
  }
}

std::optional<Eigen::VectorXd> LineChoice::near(const Eigen::VectorXd& y0, double& work) const {
  Eigen::VectorXd y = y0;
  Eigen::MatrixXd C = C_;
  spread(y, C, work);
  const auto size = static_cast<double>(y.size());
  const Eigen::VectorXd least = kDetermined * C_.diagonal();
  std::vector<char> isFixed(at(y.size()), 0);
  const auto moveAlong = [&](const Eigen::VectorXd& column, double factor) {
    if (!(std::fabs(factor) * column.lpNorm<Eigen::Infinity>() < kLargestMove)) return;
    for (Eigen::Index i = 0; i < y.size(); ++i)
      if (!isFixed[at(i)]) y[i] += factor * column[i];
  };
  for (Eigen::Index step = 0; step < y.size(); ++step) {
    if (work <= 0.0) return std::nullopt;
    Eigen::Index next = -1;
    double nearest = std::numeric_limits<double>::infinity();
    for (Eigen::Index j = 0; j < y.size(); ++j) {
      const double rest = std::fabs(y[j] - std::nearbyint(y[j]));
      if (isFixed[at(j)] || rest >= nearest) continue;
      nearest = rest;
      next = j;
    }
    const double change = roundedAt(next, y, isFixed) - y[next];
    const Eigen::VectorXd column = C.col(next);
    y[next] += change;
    isFixed[at(next)] = 1;
    if (column[next] > least[next]) {
      moveAlong(column, change / column[next]);
      C.noalias() -= column * (column / column[next]).transpose();
      work -= size * size;
    }
    moveBack(C, isFixed, y, work);
  }
  repair(y, work);
  if (work <= 0.0) return std::nullopt;
  return y;
}

double LineChoice::missing(const LineDemand& demand, const Eigen::VectorXd& y) const {
  return std::max(0.0, demand.least - valueOf(demand, y) - kLineZero);
}

double LineChoice::missing(const Eigen::VectorXd& y) const {
  double sum = 0.0;
  for (const LineDemand& demand : demands_) sum += missing(demand, y);
  return sum;
}

/// Moves number j by a unit, then those that this presses on, each once.
void LineChoice::push(Eigen::Index j, double unit, Eigen::VectorXd& y) const {
  std::vector<char> isMoved(at(y.size()), 0);
  std::vector<Eigen::Index> queue{j};
  y[j] += unit;
  isMoved[at(j)] = 1;
  for (std::size_t next = 0; next < queue.size(); ++next)
    for (const int n : users_[at(queue[next])]) {
      const LineDemand& demand = demands_[at(n)];
      const double lack = missing(demand, y);
      if (lack <= 0.0) continue;
      const std::pair<int, double>* easiest = nullptr;
      for (const auto& term : demand.terms)
        if (!isMoved[at(term.first)] &&
            (!easiest || C_(term.first, term.first) > C_(easiest->first, easiest->first)))
          easiest = &term;
      if (!easiest) continue;
      y[easiest->first] +=
          std::copysign(std::ceil(lack / std::fabs(easiest->second)), easiest->second);
      isMoved[at(easiest->first)] = 1;
      queue.push_back(easiest->first);
    }
}

void LineChoice::repair(Eigen::VectorXd& y, double& work) const {
  if (broken(y) > kHopelesslyBroken) return;
  double lack = missing(y);
  for (int step = 0; step < kRepairSteps && lack > 0.0 && work > 0.0; ++step) {
    Eigen::VectorXd best;
    double bestLack = lack, bestMove = 0.0;
    for (const LineDemand& demand : demands_) {
      if (missing(demand, y) <= 0.0) continue;
      for (const auto& [j, factor] : demand.terms) {
        Eigen::VectorXd moved = y;
        work -= termCount_ + static_cast<double>(y.size());
        push(j, factor > 0.0 ? 1.0 : -1.0, moved);
        const double own = missing(moved), move = (moved - y).lpNorm<1>();
        if (own > bestLack || (own == bestLack && (best.size() == 0 || move >= bestMove))) continue;
        if (own >= lack) continue;
        best = std::move(moved);
        bestLack = own;
        bestMove = move;
      }
    }
    if (best.size() == 0) return;
    y = std::move(best);
    lack = bestLack;
  }
}

}  // namespace hgp
