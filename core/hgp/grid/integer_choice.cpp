#include "hgp/grid/integer_choice.h"

#include <Eigen/Cholesky>
#include <cmath>

#include "hgp/base/portable_math.h"

namespace hgp {
namespace {

const double kCosine72 = portable::cos(0.4 * kPi);
constexpr double kZero = 1e-6;
constexpr int kStepsPerUnknown = 6;

Complex nearest(const Complex& z) { return {std::nearbyint(z.real()), std::nearbyint(z.imag())}; }

bool isWrong(const Complex& wanted, const Complex& d) {
  if (portable::abs(d) < kZero) return true;
  return std::real(std::conj(wanted) * d) < kCosine72 * portable::abs(wanted) * portable::abs(d);
}

Complex evaluate(const Separation& s, const Eigen::VectorXcd& y) {
  Complex sum = 0.0;
  for (const auto& [j, factor] : s.terms) sum += factor * y[j];
  return sum;
}

Eigen::VectorXcd toVector(const std::vector<Gaussian>& y) {
  Eigen::VectorXcd out(static_cast<Eigen::Index>(y.size()));
  for (std::size_t j = 0; j < y.size(); ++j) out[static_cast<Eigen::Index>(j)] = toComplex(y[j]);
  return out;
}

}  // namespace

IntegerChoice::IntegerChoice(Eigen::MatrixXcd S, std::vector<Separation> separations)
    : S_(std::move(S)) {
  covariance_ = S_.ldlt().solve(Eigen::MatrixXcd::Identity(S_.rows(), S_.rows()));
  setSeparations(std::move(separations));
}

void IntegerChoice::setSeparations(std::vector<Separation> separations) {
  separations_ = std::move(separations);
  users_.assign(at(S_.rows()), {});
  for (std::size_t n = 0; n < separations_.size(); ++n)
    for (const auto& [j, factor] : separations_[n].terms)
      users_[at(j)].push_back({static_cast<int>(n), factor});
}

std::vector<Gaussian> IntegerChoice::rounded(const Eigen::VectorXcd& y0) const {
  const Eigen::Index k = y0.size();
  Eigen::VectorXcd y = y0;
  Eigen::MatrixXcd C = covariance_;
  std::vector<char> isDone(at(k), 0);
  for (Eigen::Index n = 0; n < k; ++n) {
    Eigen::Index best = -1;
    double distance = 0.0;
    for (Eigen::Index j = 0; j < k; ++j) {
      if (isDone[at(j)]) continue;
      const double d = portable::abs(nearest(y[j]) - y[j]);
      if (best >= 0 && d >= distance) continue;
      best = j;
      distance = d;
    }
    isDone[at(best)] = 1;
    const double variance = C(best, best).real();
    // Only the lower triangle is kept.
    Eigen::VectorXcd column = C.col(best);
    column.head(best) = C.row(best).head(best).adjoint();
    for (Eigen::Index j = 0; j < k; ++j)
      if (isDone[at(j)]) column[j] = 0.0;
    const Complex change = nearest(y[best]) - y[best];
    if (variance > 0.0) {
      y += column * (change / variance);
      C.selfadjointView<Eigen::Lower>().rankUpdate(column, -1.0 / variance);
    }
    y[best] = nearest(y[best]);
  }
  std::vector<Gaussian> out;
  for (Eigen::Index j = 0; j < k; ++j)
    out.push_back({std::llround(y[j].real()), std::llround(y[j].imag())});
  return out;
}

void IntegerChoice::descend(const Eigen::VectorXcd& y0, std::vector<Gaussian>& y) const {
  const Eigen::Index k = y0.size();
  Eigen::VectorXcd gradient = S_ * (toVector(y) - y0);
  const Eigen::VectorXcd start = toVector(y);
  std::vector<Complex> wanted, now;
  for (const Separation& s : separations_) {
    wanted.push_back(evaluate(s, y0));
    now.push_back(evaluate(s, start));
  }
  for (Eigen::Index step = 0; step < kStepsPerUnknown * k + 50; ++step) {
    Eigen::Index best = -1;
    int bestTurn = 0, bestWrong = 0;
    double bestChange = -1e-12;
    // Only an unknown of a wrong separation can correct one; the others must lower Q by more than the best.
    std::vector<char> canCorrect(at(k), 0);
    for (std::size_t n = 0; n < separations_.size(); ++n)
      if (isWrong(wanted[n], now[n]))
        for (const auto& [j, factor] : separations_[n].terms) canCorrect[at(j)] = 1;
    for (Eigen::Index j = 0; j < k; ++j)
      for (int turn = 0; turn < 4; ++turn) {
        const Complex unit = toComplex(quarterTurn(turn));
        const double change = 2.0 * std::real(std::conj(unit) * gradient[j]) + S_(j, j).real();
        if (!canCorrect[at(j)] && change >= bestChange) continue;
        int wrong = 0;
        for (const auto& [n, factor] : users_[at(j)])
          wrong += isWrong(wanted[at(n)], now[at(n)] + factor * unit) -
                   isWrong(wanted[at(n)], now[at(n)]);
        if (wrong > bestWrong || (wrong == bestWrong && change >= bestChange)) continue;
        best = j;
        bestTurn = turn;
        bestWrong = wrong;
        bestChange = change;
      }
    if (best < 0) return;
    const Gaussian unit = quarterTurn(bestTurn);
    y[at(best)] = y[at(best)] + unit;
    gradient += S_.col(best) * toComplex(unit);
    for (const auto& [n, factor] : users_[at(best)]) now[at(n)] += factor * toComplex(unit);
  }
}

std::vector<Gaussian> IntegerChoice::near(const Eigen::VectorXcd& y0) const {
  std::vector<Gaussian> y = rounded(y0);
  descend(y0, y);
  return y;
}

int IntegerChoice::wrongSeparations(const Eigen::VectorXcd& y0,
                                    const std::vector<Gaussian>& y) const {
  const Eigen::VectorXcd chosen = toVector(y);
  int count = 0;
  for (const Separation& s : separations_) count += isWrong(evaluate(s, y0), evaluate(s, chosen));
  return count;
}

double IntegerChoice::energy(const Eigen::VectorXcd& y0, const std::vector<Gaussian>& y) const {
  const Eigen::VectorXcd d = toVector(y) - y0;
  return std::real(d.dot(S_ * d));
}

}  // namespace hgp
