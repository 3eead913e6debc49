#include "hgp/improve/energy.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "support/random.h"

namespace hgp {
namespace {

using Vector4 = Eigen::Vector4d;
using Matrix4 = Eigen::Matrix4d;

const std::vector<EnergyExponents> kFamily{
    {1.0, 1.0}, {1.0, 1e-3}, {0.1, 1.0}, {0.7, 1.0}, {1.0, 0.4}};

/// Members with a knee: below, at and above what most triangles have.
const std::vector<EnergyExponents> kBent{{1.0, 1e-3, 1e-3}, {1.0, 0.4, 0.1}, {1.0, 1.0, 2.0}};

/// A positive triangle: |m| < |p|, areas between 1/20 and 20, some of them all but degenerate.
std::pair<Complex, Complex> randomParts(std::mt19937& random) {
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * 0.5 * (1.0 + test::randomReal(random));
  };
  const double mu = uniform(0.0, 1.0) < 0.3 ? uniform(0.9, 0.99) : uniform(0.0, 0.9);
  const double size = std::exp(uniform(-1.5, 1.5));
  return {std::polar(size, uniform(-kPi, kPi)), std::polar(mu * size, uniform(-kPi, kPi))};
}

double at(const EnergyExponents& e, const Vector4& v) {
  return energy(e, {v[0], v[1]}, {v[2], v[3]});
}
Vector4 pack(const Complex& p, const Complex& m) {
  return {p.real(), p.imag(), m.real(), m.imag()};
}

Matrix4 hessianOf(const EnergyJet& jet) {
  Matrix4 sum = Matrix4::Zero();
  for (std::size_t k = 0; k < 4; ++k) {
    const Vector4 along = pack(jet.alongP[k], jet.alongM[k]);
    sum += jet.curvature[k] * along * along.transpose();
  }
  return sum;
}

/// Derivatives by central differences of fourth order.
Vector4 differentiate(const EnergyExponents& e, const Vector4& v, double h) {
  Vector4 gradient;
  for (int i = 0; i < 4; ++i) {
    const Vector4 step = h * Vector4::Unit(i);
    gradient[i] = (8.0 * (at(e, v + step) - at(e, v - step)) -
                   (at(e, v + 2.0 * step) - at(e, v - 2.0 * step))) /
                  (12.0 * h);
  }
  return gradient;
}

/// The full Hessian by differences of the gradient.
Matrix4 differentiateTwice(const EnergyExponents& e, const Vector4& v, double h) {
  const auto gradient = [&](const Vector4& w) {
    const EnergyJet jet = energyJet(e, {w[0], w[1]}, {w[2], w[3]});
    return pack(jet.gradientP, jet.gradientM);
  };
  Matrix4 H;
  for (int i = 0; i < 4; ++i) {
    const Vector4 step = h * Vector4::Unit(i);
    H.col(i) = (8.0 * (gradient(v + step) - gradient(v - step)) -
                (gradient(v + 2.0 * step) - gradient(v - 2.0 * step))) /
               (12.0 * h);
  }
  return 0.5 * (H + H.transpose());
}

TEST(Energy, IsTheProductOfAngleAndAreaTermsOfTheSingularValues) {
  std::mt19937 random(7);
  for (int n = 0; n < 500; ++n) {
    const auto [p, m] = randomParts(random);
    const double large = std::abs(p) + std::abs(m), small = std::abs(p) - std::abs(m);
    const double K = 0.5 * (large / small + small / large);
    const double D = 0.5 * (large * small + 1.0 / (large * small));
    for (const EnergyExponents& e : kFamily) {
      const double expected = std::pow(K, e.angle) * std::pow(D, e.area);
      EXPECT_NEAR(energy(e, p, m), expected, 1e-10 * expected);
      EXPECT_NEAR(energyJet(e, p, m).value, expected, 1e-10 * expected);
    }
    const double dirichlet =
        0.25 * (large * large + small * small + 1.0 / (large * large) + 1.0 / (small * small));
    EXPECT_NEAR(energy({1.0, 1.0}, p, m), dirichlet, 1e-10 * dirichlet);
  }
}

TEST(Energy, WithAKneeGrowsAsBeforeBelowItAndLikeTheRootAboveIt) {
  const double knee = 1e-2;
  const auto excessAt = [&](const EnergyExponents& e, double mu) {
    return energy(e, 1.0, mu) - 1.0;
  };
  const EnergyExponents plain{1.0, 1e-9}, bent{1.0, 1e-9, knee};
  for (const double mu : {1e-4, 1e-3, 0.01, 0.1, 0.5, 0.9}) {
    const double k = excessAt(plain, mu);
    EXPECT_NEAR(excessAt(bent, mu), 2.0 * knee * (std::sqrt(1.0 + k / knee) - 1.0),
                1e-9 * k + 1e-15);
    EXPECT_LE(excessAt(bent, mu), k);
  }
  EXPECT_NEAR(excessAt(bent, 1e-3) / excessAt(plain, 1e-3), 1.0, 1e-3);
  // Far above: 2√(κk) with k = 2μ²/(1 − μ²).
  EXPECT_NEAR(excessAt(bent, 0.99), 2.0 * std::sqrt(knee * excessAt(plain, 0.99)), 2.1 * knee);
}

TEST(Energy, WithAKneeTheHessianIsAMajorizer) {
  std::mt19937 random(19);
  for (int n = 0; n < 300; ++n) {
    const auto [p, m] = randomParts(random);
    for (const EnergyExponents& e : kBent) {
      const EnergyJet jet = energyJet(e, p, m);
      EXPECT_NEAR(jet.value, energy(e, p, m), 1e-10 * jet.value);
      const double h = 1e-3 * (std::abs(p) - std::abs(m));
      const Vector4 slope = differentiate(e, pack(p, m), h);
      const Vector4 have = pack(jet.gradientP, jet.gradientM);
      EXPECT_LT((have - slope).norm(),
                1e-6 * (slope.norm() + jet.value / (std::abs(p) - std::abs(m))));
      const Matrix4 truth = differentiateTwice(e, pack(p, m), h);
      const Eigen::SelfAdjointEigenSolver<Matrix4> above(hessianOf(jet) - truth);
      EXPECT_GT(above.eigenvalues()[0], -1e-4 * truth.norm());
    }
  }
}

TEST(Energy, IsOneAtIsometriesAndInfiniteWhereATriangleIsNotPositive) {
  for (const EnergyExponents& e : kFamily) {
    EXPECT_NEAR(energy(e, std::polar(1.0, 0.7), 0.0), 1.0, 1e-14);
    EXPECT_TRUE(std::isinf(energy(e, 1.0, Complex(0.0, 1.0))));
    EXPECT_TRUE(std::isinf(energy(e, 0.5, 0.6)));
    EXPECT_TRUE(std::isinf(energy(e, 0.0, 0.0)));
  }
}

TEST(Energy, GradientAgreesWithDifferences) {
  std::mt19937 random(11);
  for (int n = 0; n < 300; ++n) {
    const auto [p, m] = randomParts(random);
    const double gap = std::abs(p) - std::abs(m);
    for (const EnergyExponents& e : kFamily) {
      const EnergyJet jet = energyJet(e, p, m);
      const Vector4 expected = differentiate(e, pack(p, m), 1e-3 * gap);
      const Vector4 have = pack(jet.gradientP, jet.gradientM);
      EXPECT_LT((have - expected).norm(), 1e-7 * (expected.norm() + jet.value / gap));
    }
  }
}

TEST(Energy, HessianIsTheTrueOneWithItsNegativeEigenvaluesRaised) {
  std::mt19937 random(13);
  int indefinite = 0;
  for (int n = 0; n < 300; ++n) {
    const auto [p, m] = randomParts(random);
    for (const EnergyExponents& e : kFamily) {
      const Matrix4 truth = differentiateTwice(e, pack(p, m), 1e-3 * (std::abs(p) - std::abs(m)));
      const Eigen::SelfAdjointEigenSolver<Matrix4> eigen(truth);
      indefinite += eigen.eigenvalues()[0] < -1e-3 * eigen.eigenvalues()[3];
      const Matrix4 projected = eigen.eigenvectors() *
                                eigen.eigenvalues().cwiseMax(0.0).asDiagonal() *
                                eigen.eigenvectors().transpose();
      const Matrix4 have = hessianOf(energyJet(e, p, m));
      EXPECT_LT((have - projected).norm(), 5e-5 * projected.norm());
    }
  }
  EXPECT_GT(indefinite, 300);  // otherwise the projection was not tested
}

TEST(Energy, CurvaturesArePositiveAndDirectionsOrthonormal) {
  std::mt19937 random(17);
  for (int n = 0; n < 300; ++n) {
    const auto [p, m] = n == 0 ? std::pair<Complex, Complex>(1.0, 0.0) : randomParts(random);
    for (const EnergyExponents& e : kFamily) {
      const EnergyJet jet = energyJet(e, p, m);
      for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_GT(jet.curvature[i], 0.0);
        for (std::size_t j = 0; j < 4; ++j)
          EXPECT_NEAR(pack(jet.alongP[i], jet.alongM[i]).dot(pack(jet.alongP[j], jet.alongM[j])),
                      i == j ? 1.0 : 0.0, 1e-12);
      }
    }
  }
}

TEST(Energy, ExponentsRunFromAnglesOverSymmetricDirichletToAreas) {
  EXPECT_DOUBLE_EQ(exponentsAt(0.0).angle, 1.0);
  EXPECT_DOUBLE_EQ(exponentsAt(0.0).area, 1.0);
  EXPECT_LT(exponentsAt(-1.0).knee, 1e-2);
  EXPECT_EQ(exponentsAt(0.0).knee, EnergyExponents::kNoKnee);
  double last = 0.0, lastKnee = 0.0;
  for (double balance = -1.5; balance <= 1.5; balance += 0.125) {
    const EnergyExponents e = exponentsAt(balance);
    EXPECT_GT(e.angle, 0.0);
    EXPECT_GT(e.area, 0.0);
    EXPECT_DOUBLE_EQ(std::max(e.angle, e.area), 1.0);
    EXPECT_GE(e.area / e.angle, last);
    last = e.area / e.angle;
    EXPECT_GE(e.knee, lastKnee);
    lastKnee = e.knee;
  }
}

}  // namespace
}  // namespace hgp
