#include "hgp/grid/line_steps.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/ids.h"

namespace hgp {
namespace {

/// Steps and changes of weights, at most, and broken demands whose numbers are looked at for one step.
constexpr int kMendingSteps = 4000, kLookedAt = 12;
/// Relative differences below this are rounding errors.
constexpr double kSame = 1e-9;

}  // namespace

Eigen::VectorXd realParts(const std::vector<Gaussian>& y) {
  Eigen::VectorXd out(static_cast<Eigen::Index>(y.size()));
  for (std::size_t j = 0; j < y.size(); ++j)
    out[static_cast<Eigen::Index>(j)] = toComplex(y[j]).real();
  return out;
}

double LineDemand::valueAt(const Eigen::VectorXd& y) const {
  double value = 0.0;
  for (const auto& [j, factor] : terms) value += factor * y[j];
  return value;
}

double LineDemand::missingAt(const Eigen::VectorXd& y) const {
  return std::max(0.0, least - valueAt(y) - kLineZero);
}

struct LineSteps::State {
  Eigen::VectorXd w, gradient;  ///< S (w − w₀)
  Eigen::VectorXd values;       ///< of the demands
  std::vector<double> weights;  ///< of the demands
};

LineSteps::LineSteps(const Eigen::MatrixXd& S, const std::vector<LineDemand>& demands)
    : form_(S.cast<Complex>()), users_(at(S.rows())) {
  for (const LineDemand& demand : demands) {
    LineDemand reduced{{}, demand.least};
    IntegerForm::Terms terms;
    for (const auto& [j, factor] : demand.terms) terms.push_back({j, Complex(factor)});
    for (const auto& [j, factor] : form_.toReduced(terms)) {
      reduced.terms.push_back({j, factor.real()});
      users_[at(j)].push_back({static_cast<int>(demands_.size()), factor.real()});
    }
    demands_.push_back(std::move(reduced));
  }
}

/// The change of the weighted sum of what is missing.
double LineSteps::scoreOf(const State& state, const Step& step) const {
  double score = 0.0;
  for (const auto& [n, factor] : users_[at(step.number)]) {
    const double lack = demands_[at(n)].least - state.values[n];
    const double after = std::max(0.0, lack - factor * step.unit) - std::max(0.0, lack);
    score += state.weights[at(n)] * after;
  }
  return score;
}

/// The change of the form.
double LineSteps::changeOf(const State& state, const Step& step) const {
  const double own = form_.matrix()(step.number, step.number).real();
  return 2.0 * step.unit * state.gradient[step.number] + own;
}

/// The step that lowers the score most; none where none does.
LineSteps::Step LineSteps::bestFor(const State& state, const std::vector<int>& broken, int turn,
                                   double& work) const {
  std::vector<char> isSeen(users_.size(), 0);
  const std::size_t looked = std::min<std::size_t>(broken.size(), kLookedAt);
  Step best;
  double bestScore = -kSame, bestChange = 0.0;
  for (std::size_t k = 0; k < looked; ++k) {
    // Another part of a long list each time.
    const std::size_t n = (static_cast<std::size_t>(turn) * looked + k) % broken.size();
    for (const auto& term : demands_[at(broken[n])].terms) {
      if (isSeen[at(term.first)]) continue;
      isSeen[at(term.first)] = 1;
      for (const double unit : {1.0, -1.0}) {
        const Step step{term.first, unit};
        const double score = scoreOf(state, step), change = changeOf(state, step);
        work -= static_cast<double>(users_[at(term.first)].size());
        if (score > bestScore + kSame) continue;
        if (score > bestScore - kSame && (best.number < 0 || change >= bestChange)) continue;
        best = step;
        bestScore = score;
        bestChange = change;
      }
    }
  }
  return best;
}

void LineSteps::take(State& state, const Step& step, double& work) const {
  state.w[step.number] += step.unit;
  state.gradient += step.unit * form_.matrix().col(step.number).real();
  for (const auto& [n, factor] : users_[at(step.number)]) state.values[n] += factor * step.unit;
  work -= static_cast<double>(state.w.size());
}

std::vector<int> LineSteps::brokenAt(const State& state) const {
  std::vector<int> broken;
  for (std::size_t n = 0; n < demands_.size(); ++n)
    if (state.values[static_cast<Eigen::Index>(n)] < demands_[n].least - kLineZero)
      broken.push_back(static_cast<int>(n));
  return broken;
}

/// True when all demands are fulfilled; otherwise the state is the best that was seen.
bool LineSteps::mend(State& state, double& work) const {
  Eigen::VectorXd best = state.w;
  std::size_t fewest = demands_.size() + 1;
  for (int turn = 0; turn < kMendingSteps && work > 0.0; ++turn) {
    const std::vector<int> broken = brokenAt(state);
    work -= static_cast<double>(demands_.size());
    if (broken.empty()) return true;
    if (broken.size() < fewest) {
      fewest = broken.size();
      best = state.w;
    }
    const Step step = bestFor(state, broken, turn, work);
    if (step.number >= 0)
      take(state, step, work);
    else
      for (const int n : broken) state.weights[at(n)] += 1.0;
  }
  state.w = best;
  return false;
}

void LineSteps::descend(State& state, double& work) const {
  const auto breaks = [&](const Step& step) {
    return std::any_of(
        users_[at(step.number)].begin(), users_[at(step.number)].end(), [&](const auto& use) {
          const LineDemand& demand = demands_[at(use.first)];
          return state.values[use.first] + use.second * step.unit < demand.least - kLineZero;
        });
  };
  for (Eigen::Index turn = 0; turn < 6 * state.w.size() && work > 0.0; ++turn) {
    Step best;
    double bestChange = 0.0;
    for (Eigen::Index j = 0; j < state.w.size(); ++j)
      for (const double unit : {1.0, -1.0}) {
        const Step step{j, unit};
        const double change = changeOf(state, step);
        const double least = -kSame * form_.matrix()(j, j).real();
        if (change >= std::min(bestChange, least) || breaks(step)) continue;
        best = step;
        bestChange = change;
      }
    work -= static_cast<double>(state.w.size());
    if (best.number < 0) return;
    take(state, best, work);
  }
}

Eigen::VectorXd LineSteps::mended(const Eigen::VectorXd& y0, const Eigen::VectorXd& y,
                                  double& work) const {
  const Eigen::VectorXd w0 = form_.toReduced(y0.cast<Complex>()).real();
  State state;
  state.w = form_.toReduced(y.cast<Complex>()).real();
  state.gradient = form_.matrix().real() * (state.w - w0);
  state.values.resize(static_cast<Eigen::Index>(demands_.size()));
  for (std::size_t n = 0; n < demands_.size(); ++n)
    state.values[static_cast<Eigen::Index>(n)] = demands_[n].valueAt(state.w);
  state.weights.assign(demands_.size(), 1.0);
  if (mend(state, work)) descend(state, work);
  std::vector<Gaussian> w;
  for (Eigen::Index j = 0; j < state.w.size(); ++j) w.push_back({std::llround(state.w[j]), 0});
  return realParts(form_.toOriginal(std::move(w)));
}

}  // namespace hgp
