#include "hgp/field/nearest_lattice_point.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

namespace hgp {
namespace {

struct Case {
  Eigen::MatrixXd M;
  Eigen::VectorXd step, offset;
};

/// A metric that is far from diagonal, steps of two sizes and an offset; the same bits on every platform.
Case drawn(int n, unsigned seed) {
  std::mt19937 random(seed);
  const auto draw = [&] { return static_cast<double>(random()) / 2147483648.0 - 1.0; };
  Case c{Eigen::MatrixXd::Identity(n, n), Eigen::VectorXd(n), Eigen::VectorXd(n)};
  Eigen::MatrixXd A(n, n);
  for (Eigen::Index i = 0; i < A.size(); ++i) A.data()[i] = draw();
  c.M = A * A.transpose() + 0.02 * Eigen::MatrixXd::Identity(n, n);
  for (int i = 0; i < n; ++i) {
    c.step[i] = i % 2 == 0 ? 1.5 : 0.5;
    c.offset[i] = 4.0 * draw();
  }
  return c;
}

double square(const Eigen::MatrixXd& M, const Eigen::VectorXd& x) { return x.dot(M.inverse() * x); }

TEST(NearestLatticePoint, IsAPointOfTheLattice) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Case c = drawn(6, seed);
    const Eigen::VectorXd x = NearestLatticePoint(c.M, c.step).round(c.offset);
    for (int i = 0; i < 6; ++i) {
      const double times = (x[i] - c.offset[i]) / c.step[i];
      EXPECT_NEAR(times, std::round(times), 1e-9);
    }
  }
}

TEST(NearestLatticePoint, NoOtherPointIsNearer) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    const Case c = drawn(3, seed);
    const Eigen::VectorXd x = NearestLatticePoint(c.M, c.step).round(c.offset);
    const Eigen::Matrix3d metric = c.M.inverse();
    const double found = square(c.M, x);
    double nearest = found;
    for (int i = -9; i <= 9; ++i)
      for (int j = -9; j <= 9; ++j)
        for (int k = -9; k <= 9; ++k) {
          const Eigen::Vector3d other = x + c.step.cwiseProduct(Eigen::Vector3d(i, j, k));
          nearest = std::min(nearest, other.dot(metric * other));
        }
    EXPECT_GE(nearest, found * (1.0 - 1e-9)) << seed;
  }
}

TEST(NearestLatticePoint, DoesNotDependOnTheBasis) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    const int n = 8;
    Case c = drawn(n, seed);
    c.step.setOnes();
    // x = T y with a unimodular T: the same lattice and metric in other coordinates.
    Eigen::MatrixXd T = Eigen::MatrixXd::Identity(n, n);
    for (int i = 0; i + 1 < n; ++i)
      T.col((3 * i + 1) % n) += (i % 3 - 1.0) * T.col((5 * i + 2) % n);
    const Eigen::MatrixXd back = T.inverse();
    const Eigen::VectorXd x = NearestLatticePoint(c.M, c.step).round(c.offset);
    const Eigen::VectorXd y =
        NearestLatticePoint(back * c.M * back.transpose(), c.step).round(back * c.offset);
    EXPECT_LT((T * y - x).norm(), 1e-8) << seed;
  }
}

TEST(NearestLatticePoint, SolvesInTheMetric) {
  const Case c = drawn(5, 3);
  EXPECT_LT((c.M * NearestLatticePoint(c.M, c.step).solve(c.offset) - c.offset).norm(), 1e-9);
}

TEST(NearestLatticePoint, EndsInManyDimensions) {
  const Case c = drawn(120, 1);
  const Eigen::VectorXd x = NearestLatticePoint(c.M, c.step).round(c.offset);
  EXPECT_LT(square(c.M, x), square(c.M, c.offset));
}

}  // namespace
}  // namespace hgp
