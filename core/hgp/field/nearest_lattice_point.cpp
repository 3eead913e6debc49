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
constexpr int kExchangesPerPair = 100;

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

/// Columns B of a basis, their Gram–Schmidt coefficients, and T with B = B₀ T.
class Reduction {
 public:
  explicit Reduction(Eigen::MatrixXd B)
      : B_(std::move(B)),
        T_(Eigen::MatrixXd::Identity(B_.cols(), B_.cols())),
        mu_(Eigen::MatrixXd::Identity(B_.cols(), B_.cols())),
        square_(B_.cols()) {
    Eigen::MatrixXd Q, R;
    orthonormalise(B_, Q, R);
    for (Eigen::Index k = 0; k < B_.cols(); ++k) {
      for (Eigen::Index j = 0; j < k; ++j) mu_(k, j) = R(j, k) / R(j, j);
      square_[k] = R(k, k) * R(k, k);
    }
  }

  /// Cohen, A Course in Computational Algebraic Number Theory, algorithm 2.6.3.
  Eigen::MatrixXd reduce() {
    const Eigen::Index n = B_.cols();
    Eigen::Index exchanges = kExchangesPerPair * n * n;
    for (Eigen::Index k = 1; k < n;) {
      shorten(k, k - 1);
      const double m = mu_(k, k - 1);
      if (square_[k] < (kLovasz - m * m) * square_[k - 1] && --exchanges > 0) {
        exchange(k);
        k = std::max<Eigen::Index>(k - 1, 1);
        continue;
      }
      for (Eigen::Index j = k - 1; j-- > 0;) shorten(k, j);
      ++k;
    }
    return T_;
  }

 private:
  void shorten(Eigen::Index k, Eigen::Index j) {
    const double times = std::round(mu_(k, j));
    if (times == 0.0) return;
    B_.col(k) -= times * B_.col(j);
    T_.col(k) -= times * T_.col(j);
    mu_.row(k).head(j + 1) -= times * mu_.row(j).head(j + 1);
  }

  void exchange(Eigen::Index k) {
    B_.col(k).swap(B_.col(k - 1));
    T_.col(k).swap(T_.col(k - 1));
    const double m = mu_(k, k - 1);
    const double sum = square_[k] + m * m * square_[k - 1];
    mu_(k, k - 1) = m * square_[k - 1] / sum;
    square_[k] *= square_[k - 1] / sum;
    square_[k - 1] = sum;
    mu_.row(k).head(k - 1).swap(mu_.row(k - 1).head(k - 1));
    for (Eigen::Index i = k + 1; i < B_.cols(); ++i) {
      const double before = mu_(i, k);
      mu_(i, k) = mu_(i, k - 1) - m * before;
      mu_(i, k - 1) = before + mu_(k, k - 1) * mu_(i, k);
    }
  }

  Eigen::MatrixXd B_, T_, mu_;
  Eigen::VectorXd square_;  ///< |b*|²
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
