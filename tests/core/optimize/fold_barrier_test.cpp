// The energy against foldovers.  Laws: gradients and Hessians are the derivatives of the value; where a model is
// clamped, it is the nearest convex one.
#include "hgp/optimize/fold_barrier.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <functional>

#include "support/random.h"

namespace hgp {
namespace {

constexpr double kScaleWeight = 0.3;

using Energy = std::function<double(const Eigen::Vector4d&)>;

Eigen::Vector4d gradientOf(const Energy& energy, const Eigen::Vector4d& x) {
  constexpr double h = 1e-5;
  Eigen::Vector4d gradient;
  for (int i = 0; i < 4; ++i) {
    const Eigen::Vector4d d = h * Eigen::Vector4d::Unit(i);
    gradient[i] = (energy(x + d) - energy(x - d)) / (2.0 * h);
  }
  return gradient;
}

Eigen::Matrix4d hessianOf(const Energy& energy, const Eigen::Vector4d& x) {
  constexpr double h = 1e-4;
  Eigen::Matrix4d hessian;
  for (int i = 0; i < 4; ++i) {
    const Eigen::Vector4d d = h * Eigen::Vector4d::Unit(i);
    hessian.col(i) = (gradientOf(energy, x + d) - gradientOf(energy, x - d)) / (2.0 * h);
  }
  return 0.5 * (hessian + hessian.transpose());
}

/// The nearest positive semidefinite matrix.
Eigen::Matrix4d clamped(const Eigen::Matrix4d& H) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> eigen(H);
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).asDiagonal() *
         eigen.eigenvectors().transpose();
}

/// Over (Re, Im) of f_z and of f_z̄.
double freeEnergy(const Eigen::Vector4d& x, double epsilon) {
  const double P = x[0] * x[0] + x[1] * x[1], Q = x[2] * x[2] + x[3] * x[3];
  return barrierValue(P + Q, P - Q, kScaleWeight, epsilon);
}
double framedEnergy(const Eigen::Vector4d& x, double epsilon) {
  const double Q = x[2] * x[2] + x[3] * x[3], A = x[0];
  return barrierValue(A * A + x[1] * x[1] + Q, A * std::sqrt(A * A + epsilon) - Q, kScaleWeight,
                      epsilon);
}

template <class Check>
void forRandomTriangles(Check check) {
  std::mt19937 random(83);
  for (int n = 0; n < 300; ++n) {
    const double a = 0.3 + std::abs(test::randomReal(random));
    const double b = 0.2 + std::abs(test::randomReal(random));
    check(a, b, 0.4 + std::abs(test::randomReal(random)), random);
  }
}

TEST(FoldBarrier, FreeModelsAreTheDerivativesOfTheValue) {
  // Along the radial directions f_z = a, f_z̄ = b; the tangential ones are the imaginary parts.
  forRandomTriangles([](double a, double b, double epsilon, std::mt19937&) {
    const Eigen::Vector4d x(a, 0.0, b, 0.0);
    const Energy energy = [&](const Eigen::Vector4d& y) { return freeEnergy(y, epsilon); };
    Eigen::Vector4d slope;
    const Eigen::Matrix4d model = freeModel(a, b, kScaleWeight, epsilon, slope);
    const Eigen::Vector4d gradient = gradientOf(energy, x);
    const Eigen::Matrix4d hessian = hessianOf(energy, x);
    EXPECT_LT((slope - gradient).norm(), 1e-6 * (1.0 + gradient.norm()));
    EXPECT_LT((model - clamped(hessian)).norm(), 1e-3 * (1.0 + hessian.norm()));
  });
}

TEST(FoldBarrier, FramedModelsAreTheDerivativesOfTheValue) {
  int folded = 0;
  forRandomTriangles([&](double a, double b, double epsilon, std::mt19937& random) {
    if (test::randomBelow(random, 2)) a = -a;
    const double t = test::randomReal(random);
    const Eigen::Vector4d x(a, t, b, 0.0);
    const Energy energy = [&](const Eigen::Vector4d& y) { return framedEnergy(y, epsilon); };
    Eigen::Vector4d slope;
    const Eigen::Matrix4d model = framedModel({a, t}, b, kScaleWeight, epsilon, slope);
    const Eigen::Vector4d gradient = gradientOf(energy, x);
    const Eigen::Matrix4d hessian = hessianOf(energy, x);
    EXPECT_LT((slope - gradient).norm(), 1e-6 * (1.0 + gradient.norm()));
    EXPECT_LT((model - clamped(hessian)).norm(), 1e-3 * (1.0 + hessian.norm()));
    folded += a < 0.0;
  });
  EXPECT_GT(folded, 100);
}

TEST(FoldBarrier, CollapsedTrianglesOpenAlongTheirFrames) {
  for (const double epsilon : {1e-6, 1e-3, 1.0}) {
    Eigen::Vector4d slope;
    framedModel(0.0, 0.0, kScaleWeight, epsilon, slope);
    EXPECT_LT(slope[0], 0.0) << epsilon;
    EXPECT_DOUBLE_EQ(framedArea(2.0, 0.0).value, 4.0);
    EXPECT_DOUBLE_EQ(framedArea(-2.0, 0.0).value, -4.0);
  }
}

TEST(FoldBarrier, ValuesAreFiniteForFoldedTrianglesAndGrowAsTheyFold) {
  double last = 0.0;
  for (double D = 2.0; D > -2.0; D -= 0.05) {
    const double value = barrierValue(1.0, D, 0.0, 0.1);
    EXPECT_TRUE(std::isfinite(value) && value > last) << D;
    last = value;
    // χ = ½ (D + √(D² + ε²))
    EXPECT_NEAR(value, 2.0 / (D + std::sqrt(D * D + 0.01)), 1e-9 * value);
  }
}

}  // namespace
}  // namespace hgp
