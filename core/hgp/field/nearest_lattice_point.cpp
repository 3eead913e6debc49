#include "hgp/field/nearest_lattice_point.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace hgp {
namespace {

/// δ of Lovász's condition.
constexpr double kLovasz = 0.99;
/// Exchanges per pair of vectors after which a basis is left as it is; far more than any lattice of handles needs.
constexpr std::size_t kExchangesPerPair = 100;

/// B = Q R by modified Gram–Schmidt: Q with orthonormal columns, R upper triangular with a positive diagonal.
void orthonormalise(const Eigen::MatrixXd& B, Eigen::MatrixXd& Q, Eigen::MatrixXd& R) {
  const Eigen::Index n = B.cols();
  Q = B;
  R = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    for (Eigen::Index j = 0; j < k; ++j) {
      R(j, k) = Q.col(j).dot(Q.col(k));
      Q.col(k) -= R(j, k) * Q.col(j);
    }
    R(k, k) = Q.col(k).norm();
    Q.col(k) *= 1.0 / R(k, k);
  }
}

/// A basis B₀ T: its Gram–Schmidt coefficients, and T by columns.
class Reduction {
 public:
  explicit Reduction(const Eigen::MatrixXd& B0) : size_(static_cast<std::size_t>(B0.cols())) {
    Eigen::MatrixXd Q, R;
    orthonormalise(B0, Q, R);
    for (Eigen::Index k = 0; k < B0.cols(); ++k) {
      std::vector<double>& mu = mu_.emplace_back(size_, 0.0);
      for (Eigen::Index j = 0; j < k; ++j) mu[static_cast<std::size_t>(j)] = R(j, k) / R(j, j);
      mu[static_cast<std::size_t>(k)] = 1.0;
      T_.emplace_back(size_, 0.0)[static_cast<std::size_t>(k)] = 1.0;
      square_.push_back(R(k, k) * R(k, k));
    }
  }

  /// Cohen, A Course in Computational Algebraic Number Theory, algorithm 2.6.3.
  Eigen::MatrixXd reduce() {
    std::size_t exchanges = kExchangesPerPair * size_ * size_;
    for (std::size_t k = 1; k < size_;) {
      shorten(k, k - 1);
      const double m = mu_[k][k - 1];
      if (square_[k] < (kLovasz - m * m) * square_[k - 1] && exchanges-- > 0) {
        exchange(k);
        if (k > 1) --k;
        continue;
      }
      for (std::size_t j = k - 1; j-- > 0;) shorten(k, j);
      ++k;
    }
    const auto n = static_cast<Eigen::Index>(size_);
    Eigen::MatrixXd T(n, n);
    for (std::size_t k = 0; k < size_; ++k)
      std::copy(T_[k].begin(), T_[k].end(), T.col(static_cast<Eigen::Index>(k)).data());
    return T;
  }

 private:
  void shorten(std::size_t k, std::size_t j) {
    const double times = std::round(mu_[k][j]);
    if (times == 0.0) return;
    for (std::size_t i = 0; i < size_; ++i) {
      T_[k][i] -= times * T_[j][i];
      mu_[k][i] -= times * mu_[j][i];  // 0 beyond j
    }
  }

  void exchange(std::size_t k) {
    const double m = mu_[k][k - 1];
    const double sum = square_[k] + m * m * square_[k - 1];
    T_[k].swap(T_[k - 1]);
    for (std::size_t i = 0; i + 1 < k; ++i) std::swap(mu_[k][i], mu_[k - 1][i]);
    mu_[k][k - 1] = m * square_[k - 1] / sum;
    square_[k] *= square_[k - 1] / sum;
    square_[k - 1] = sum;
    for (std::size_t i = k + 1; i < size_; ++i) {
      const double before = mu_[i][k];
      mu_[i][k] = mu_[i][k - 1] - m * before;
      mu_[i][k - 1] = before + mu_[k][k - 1] * mu_[i][k];
    }
  }

  std::size_t size_;
  std::vector<std::vector<double>> T_, mu_;
  std::vector<double> square_;  ///< |b*|²
};

}  // namespace

NearestLatticePoint::NearestLatticePoint(const Eigen::MatrixXd& M, Eigen::VectorXd step)
    : step_(std::move(step)), U_(Eigen::MatrixXd(M.inverse()).llt().matrixU()) {
  const Eigen::MatrixXd B = U_ * step_.asDiagonal();
  toGiven_ = Reduction(B).reduce();
  orthonormalise(B * toGiven_, Q_, R_);
}

/// The integers x that minimise |target + R x|: depth first from the last coordinate, nearest values first.
Eigen::VectorXd NearestLatticePoint::nearestIntegers(const Eigen::VectorXd& target) const {
  const Eigen::Index n = target.size();
  Eigen::VectorXd x = Eigen::VectorXd::Zero(n), best = x, centre(n), above(n + 1);
  above.setZero();  // above[i]: the part of the square that coordinates from i on decide
  std::vector<int> turns(static_cast<std::size_t>(n), 0);
  double shortest = std::numeric_limits<double>::infinity();
  const auto enter = [&](Eigen::Index i) {
    double rest = target[i];
    for (Eigen::Index j = i + 1; j < n; ++j) rest += R_(i, j) * x[j];
    centre[i] = -rest / R_(i, i);
    x[i] = std::round(centre[i]);
    turns[static_cast<std::size_t>(i)] = 0;
  };
  /// The next nearest value: to either side of the first in turn.
  const auto advance = [&](Eigen::Index i) {
    const int t = ++turns[static_cast<std::size_t>(i)];
    const double side = centre[i] >= std::round(centre[i]) ? 1.0 : -1.0;
    x[i] += t % 2 == 1 ? side * t : -side * t;
  };
  Eigen::Index i = n - 1;
  if (n > 0) enter(i);
  for (int points = 0; i < n && n > 0; ++points) {
    if (points >= kPoints && shortest < std::numeric_limits<double>::infinity()) break;
    const double gap = R_(i, i) * (x[i] - centre[i]);
    const double square = above[i + 1] + gap * gap;
    if (square >= shortest) {
      if (++i < n) advance(i);
    } else if (i > 0) {
      above[i] = square;
      enter(--i);
    } else {
      shortest = square;
      best = x;
      advance(0);
    }
  }
  return best;
}

Eigen::VectorXd NearestLatticePoint::round(const Eigen::VectorXd& offset) const {
  const Eigen::VectorXd target = Q_.transpose() * (U_ * offset);
  const Eigen::VectorXd integers = toGiven_ * nearestIntegers(target);
  return offset + step_.cwiseProduct(integers);
}

}  // namespace hgp
