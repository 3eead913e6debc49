#include "hgp/grid/integer_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hgp/base/portable_math.h"

namespace hgp {
namespace {

const double kCosine72 = portable::cos(0.4 * kPi);
constexpr double kZero = 1e-6;
constexpr int kStepsPerUnknown = 6;
/// Pairs closer than this multiple of the minimum distance between integers are spread apart.
constexpr double kClose = 1.5;
constexpr int kSpreadSweeps = 60;

/// The values of both functions of a separation.
struct Values {
  Complex first, second;
};

bool isWrong(const Separation& s, const Values& wanted, const Values& now) {
  if (!s.second.empty()) return std::imag(std::conj(now.first) * now.second) < kZero;
  const double length = portable::abs(now.first);
  if (length < kZero) return true;
  return std::real(std::conj(wanted.first) * now.first) <
         kCosine72 * portable::abs(wanted.first) * length;
}

Values evaluate(const Separation& s, const Eigen::VectorXcd& w) {
  Values sum;
  for (const auto& [j, factor] : s.terms) sum.first += factor * w[j];
  for (const auto& [j, factor] : s.second) sum.second += factor * w[j];
  return sum;
}

Eigen::VectorXcd toVector(const std::vector<Gaussian>& y) {
  Eigen::VectorXcd out(static_cast<Eigen::Index>(y.size()));
  for (std::size_t j = 0; j < y.size(); ++j) out[static_cast<Eigen::Index>(j)] = toComplex(y[j]);
  return out;
}

/// The unknowns on which a violated separation depends: only these can correct it.
std::vector<char> correctors(const std::vector<Separation>& separations,
                             const std::vector<Values>& wanted, const std::vector<Values>& now,
                             Eigen::Index count) {
  std::vector<char> is(at(count), 0);
  for (std::size_t n = 0; n < separations.size(); ++n) {
    if (!isWrong(separations[n], wanted[n], now[n])) continue;
    for (const auto& [j, factor] : separations[n].terms) is[at(j)] = 1;
    for (const auto& [j, factor] : separations[n].second) is[at(j)] = 1;
  }
  return is;
}

/// The inequality Re gᴴ w ≥ bound and its multiplier.
struct Demand {
  IntegerForm::Terms g;
  double bound;
  double dual = 0.0;
};

/// Demands that close neighbours be as far apart, along their direction, as the closest integers are.
std::vector<Demand> demandsOf(const std::vector<Separation>& separations,
                              const Eigen::VectorXcd& w0) {
  std::vector<Demand> demands;
  for (const Separation& s : separations) {
    if (!s.second.empty() || s.terms.empty()) continue;
    const Complex d = evaluate(s, w0).first;
    const double length = portable::abs(d);
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [j, factor] : s.terms) least = std::min(least, portable::abs(factor));
    if (length < kZero || length >= kClose * least) continue;
    Demand demand{{}, least};
    for (const auto& [j, factor] : s.terms) demand.g.push_back({j, d / length * std::conj(factor)});
    demands.push_back(std::move(demand));
  }
  return demands;
}

double valueOf(const Demand& demand, const Eigen::Ref<const Eigen::VectorXcd>& w) {
  double value = 0.0;
  for (const auto& [j, g] : demand.g) value += std::real(std::conj(g) * w[j]);
  return value;
}

}  // namespace

IntegerChoice::IntegerChoice(std::shared_ptr<const IntegerForm> form,
                             std::vector<Separation> separations)
    : form_(std::move(form)), separations_(std::move(separations)), users_(at(form_->size())) {
  for (std::size_t n = 0; n < separations_.size(); ++n) {
    Separation& s = separations_[n];
    s = {form_->toReduced(s.terms), form_->toReduced(s.second)};
    for (const auto& [j, factor] : s.terms)
      users_[at(j)].push_back({static_cast<int>(n), factor, 0.0});
    for (const auto& [j, factor] : s.second) {
      std::vector<Use>& uses = users_[at(j)];
      if (uses.empty() || uses.back().separation != static_cast<int>(n))
        uses.push_back({static_cast<int>(n), 0.0, 0.0});
      uses.back().second = factor;
    }
  }
}

/// The point nearest to w₀ at which all demands hold. This makes room for cells between close cones before rounding,
/// for all pairs together instead of one by one afterwards. Hildreth's method: corrects one inequality after the other
/// and keeps its multiplier non-negative.
Eigen::VectorXcd IntegerChoice::spread(const Eigen::VectorXcd& w0) const {
  std::vector<Demand> demands = demandsOf(separations_, w0);
  if (demands.empty()) return w0;
  // A demand contains few unknowns, and many points are asked for: one inverse serves all of them.
  if (!inverse_) inverse_ = form_->solve(Eigen::MatrixXcd::Identity(w0.size(), w0.size()));
  Eigen::MatrixXcd steps =
      Eigen::MatrixXcd::Zero(w0.size(), static_cast<Eigen::Index>(demands.size()));
  for (std::size_t n = 0; n < demands.size(); ++n)
    for (const auto& [j, g] : demands[n].g)
      steps.col(static_cast<Eigen::Index>(n)) += g * inverse_->col(j);
  Eigen::VectorXcd w = w0;
  for (int sweep = 0; sweep < kSpreadSweeps; ++sweep)
    for (std::size_t n = 0; n < demands.size(); ++n) {
      Demand& demand = demands[n];
      const auto step = steps.col(static_cast<Eigen::Index>(n));
      const double missing = demand.bound - valueOf(demand, w);
      const double change = std::max(-demand.dual, missing / valueOf(demand, step));
      if (change == 0.0) continue;
      demand.dual += change;
      w += change * step;
    }
  return w;
}

void IntegerChoice::descend(const Eigen::VectorXcd& w0, std::vector<Gaussian>& w) const {
  const Eigen::Index k = w0.size();
  const Eigen::MatrixXcd& S = form_->matrix();
  const Eigen::VectorXcd start = toVector(w);
  Eigen::VectorXcd gradient = S * (start - w0);
  std::vector<Values> wanted, now;
  for (const Separation& s : separations_) {
    wanted.push_back(evaluate(s, w0));
    now.push_back(evaluate(s, start));
  }
  const auto isWrongAt = [&](std::size_t n, const Values& values) {
    return isWrong(separations_[n], wanted[n], values);
  };
  const auto moved = [&](const Use& use, const Complex& unit) {
    const Values& from = now[at(use.separation)];
    return Values{from.first + use.factor * unit, from.second + use.second * unit};
  };
  for (Eigen::Index step = 0; step < kStepsPerUnknown * k + 50; ++step) {
    Eigen::Index best = -1;
    int bestTurn = 0, bestWrong = 0;
    double bestChange = -1e-12;
    const std::vector<char> canCorrect = correctors(separations_, wanted, now, k);
    for (Eigen::Index j = 0; j < k; ++j)
      for (int turn = 0; turn < 4; ++turn) {
        const Complex unit = toComplex(quarterTurn(turn));
        const double change = 2.0 * std::real(std::conj(unit) * gradient[j]) + S(j, j).real();
        // A step that corrects no violated separation must lower Q by more than the best step so far.
        if (!canCorrect[at(j)] && change >= bestChange) continue;
        int wrong = 0;
        for (const Use& use : users_[at(j)]) {
          const std::size_t n = at(use.separation);
          wrong += isWrongAt(n, moved(use, unit)) - isWrongAt(n, now[n]);
        }
        if (wrong > bestWrong || (wrong == bestWrong && change >= bestChange)) continue;
        best = j;
        bestTurn = turn;
        bestWrong = wrong;
        bestChange = change;
      }
    if (best < 0) return;
    const Gaussian unit = quarterTurn(bestTurn);
    w[at(best)] = w[at(best)] + unit;
    gradient += S.col(best) * toComplex(unit);
    for (const Use& use : users_[at(best)]) now[at(use.separation)] = moved(use, toComplex(unit));
  }
}

std::vector<Gaussian> IntegerChoice::near(const Eigen::VectorXcd& y0) const {
  const Eigen::VectorXcd w0 = form_->toReduced(y0);
  std::vector<Gaussian> w = form_->rounded(spread(w0));
  descend(w0, w);
  return form_->toOriginal(std::move(w));
}

int IntegerChoice::wrongPairs(const Eigen::VectorXcd& y0, const std::vector<Gaussian>& y) const {
  const Eigen::VectorXcd wanted = form_->toReduced(y0), chosen = form_->toReduced(toVector(y));
  int count = 0;
  for (const Separation& s : separations_)
    if (s.second.empty()) count += isWrong(s, evaluate(s, wanted), evaluate(s, chosen));
  return count;
}

int IntegerChoice::wrongSeparations(const Eigen::VectorXcd& y0,
                                    const std::vector<Gaussian>& y) const {
  const Eigen::VectorXcd wanted = form_->toReduced(y0), chosen = form_->toReduced(toVector(y));
  int count = 0;
  for (const Separation& s : separations_)
    count += isWrong(s, evaluate(s, wanted), evaluate(s, chosen));
  return count;
}

double IntegerChoice::energy(const Eigen::VectorXcd& y0, const std::vector<Gaussian>& y) const {
  const Eigen::VectorXcd d = form_->toReduced(Eigen::VectorXcd(toVector(y) - y0));
  return std::real(d.dot(form_->matrix() * d));
}

}  // namespace hgp
