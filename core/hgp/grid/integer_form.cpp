#include "hgp/grid/integer_form.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "hgp/base/portable_math.h"

namespace hgp {
namespace {

constexpr int kSweeps = 12;
/// Minimum decrease of a basis vector's value, as a fraction of it, for which a reduction step is made.
constexpr double kDecrease = 1e-3;

Gaussian nearestInteger(const Complex& z) {
  return {std::llround(std::nearbyint(z.real())), std::llround(std::nearbyint(z.imag()))};
}

}  // namespace

IntegerForm::IntegerForm(Eigen::MatrixXcd S) : S_(std::move(S)) {
  reduce();
  factor();
}

void IntegerForm::reduce() {
  bool isReduced = false;
  for (int sweep = 0; sweep < kSweeps && !isReduced; ++sweep) {
    isReduced = true;
    for (Eigen::Index j = 0; j < size(); ++j)
      for (Eigen::Index i = 0; i < size(); ++i) {
        if (i == j || std::norm(S_(j, i)) * 4.0 <= S_(j, j).real() * S_(j, j).real()) continue;
        const Gaussian m = nearestInteger(S_(j, i) / S_(j, j).real());
        const Complex z = toComplex(m);
        const double change =
            std::norm(z) * S_(j, j).real() - 2.0 * std::real(std::conj(z) * S_(j, i));
        if (change > -kDecrease * S_(i, i).real()) continue;
        S_.col(i) -= z * S_.col(j);
        S_.row(i) -= std::conj(z) * S_.row(j);
        steps_.push_back({i, j, m});
        isReduced = false;
      }
  }
}

/// P S Pᵀ = L Lᴴ, smallest pivot first, so that the largest are at the end, where rounding begins.
void IntegerForm::factor() {
  const Eigen::Index k = size();
  order_.resize(at(k));
  std::iota(order_.begin(), order_.end(), Eigen::Index(0));
  L_ = Eigen::MatrixXcd::Zero(k, k);
  Eigen::VectorXd diagonal = S_.diagonal().real();
  for (Eigen::Index n = 0; n < k; ++n) {
    Eigen::Index least = n;
    for (Eigen::Index i = n + 1; i < k; ++i)
      if (diagonal[order_[at(i)]] < diagonal[order_[at(least)]]) least = i;
    std::swap(order_[at(n)], order_[at(least)]);
    L_.row(n).head(n).swap(L_.row(least).head(n));
    const Eigen::Index pivot = order_[at(n)];
    Eigen::VectorXcd column(k - n);
    for (Eigen::Index i = n; i < k; ++i) column[i - n] = S_(order_[at(i)], pivot);
    column.noalias() -= L_.block(n, 0, k - n, n) * L_.row(n).head(n).adjoint();
    const double root = std::sqrt(std::max(column[0].real(), 1e-14 * S_(pivot, pivot).real()));
    L_.col(n).tail(k - n) = column / root;
    L_(n, n) = root;
    for (Eigen::Index i = n + 1; i < k; ++i) diagonal[order_[at(i)]] -= std::norm(L_(i, n));
  }
}

Eigen::VectorXcd IntegerForm::toReduced(Eigen::VectorXcd y) const {
  for (const Step& step : steps_) y[step.by] += toComplex(step.factor) * y[step.changed];
  return y;
}

std::vector<Gaussian> IntegerForm::toOriginal(std::vector<Gaussian> w) const {
  for (auto step = steps_.rbegin(); step != steps_.rend(); ++step)
    w[at(step->by)] = w[at(step->by)] - step->factor * w[at(step->changed)];
  return w;
}

IntegerForm::Terms IntegerForm::toReduced(const Terms& linear) const {
  Eigen::VectorXcd factors = Eigen::VectorXcd::Zero(size());
  for (const auto& [j, factor] : linear) factors[j] += factor;
  for (const Step& step : steps_)
    factors[step.changed] -= toComplex(step.factor) * factors[step.by];
  Terms out;
  for (Eigen::Index j = 0; j < size(); ++j)
    if (portable::abs(factors[j]) > 1e-9) out.push_back({static_cast<int>(j), factors[j]});
  return out;
}

Eigen::MatrixXcd IntegerForm::solve(const Eigen::MatrixXcd& G) const {
  Eigen::MatrixXcd permuted(G.rows(), G.cols()), out(G.rows(), G.cols());
  for (Eigen::Index n = 0; n < size(); ++n) permuted.row(n) = G.row(order_[at(n)]);
  L_.triangularView<Eigen::Lower>().solveInPlace(permuted);
  L_.adjoint().triangularView<Eigen::Upper>().solveInPlace(permuted);
  for (Eigen::Index n = 0; n < size(); ++n) out.row(order_[at(n)]) = permuted.row(n);
  return out;
}

std::vector<Gaussian> IntegerForm::rounded(const Eigen::VectorXcd& w) const {
  std::vector<Gaussian> out(at(size()));
  Eigen::VectorXcd change(size());  // in the order of elimination
  for (Eigen::Index n = size() - 1; n >= 0; --n) {
    const Eigen::Index j = order_[at(n)], rest = size() - 1 - n;
    const Complex moved = w[j] - L_.col(n).tail(rest).dot(change.tail(rest)) / L_(n, n).real();
    out[at(j)] = nearestInteger(moved);
    change[n] = toComplex(out[at(j)]) - w[j];
  }
  return out;
}

}  // namespace hgp
