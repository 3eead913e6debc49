#include "hgp/optimize/fold_barrier.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "hgp/base/portable_math.h"

namespace hgp {
namespace {

/// The energy of one triangle in a = |f_z| and b = |f_z̄|, with its derivatives.
struct FaceEnergy {
  double value, slopeA, slopeB;  ///< h, h_a / a, h_b / b
  double aa, bb, ab;             ///< h_aa, h_bb, h_ab
};

double chi(double D, double epsilon) {
  const double s = std::sqrt(D * D + epsilon * epsilon);
  return D > 0 ? 0.5 * (D + s) : 0.5 * epsilon * epsilon / (s - D);
}

FaceEnergy faceEnergy(double a, double b, double scaleWeight, double epsilon) {
  const double D = a * a - b * b, N = a * a + b * b;
  const double s = std::sqrt(D * D + epsilon * epsilon), x = chi(D, epsilon);
  const double M = N + scaleWeight * (D * D + 1.0);
  const double FN = 1.0 / x, fnd = -1.0 / (x * s);
  const double FD = 2.0 * scaleWeight * D / x - M / (x * s);
  const double fdd =
      2.0 * scaleWeight / x - 4.0 * scaleWeight * D / (x * s) + 2.0 * M / (s * s * s);
  FaceEnergy e;
  e.value = M / x;
  e.slopeA = 2.0 * (FN + FD);
  e.slopeB = 2.0 * (FN - FD);
  e.aa = e.slopeA + 4.0 * a * a * (2.0 * fnd + fdd);
  e.bb = e.slopeB + 4.0 * b * b * (-2.0 * fnd + fdd);
  e.ab = -4.0 * a * b * fdd;
  return e;
}

/// Clamps the 2 × 2 matrix (aa ab; ab bb) to positive semidefinite.
void makeConvex(FaceEnergy& e) {
  const double mean = 0.5 * (e.aa + e.bb), half = 0.5 * (e.aa - e.bb);
  const double radius = portable::hypot(half, e.ab);
  const double low = mean - radius, high = mean + radius;
  e.slopeA = std::max(e.slopeA, 0.0);
  e.slopeB = std::max(e.slopeB, 0.0);
  if (low >= 0.0) return;
  if (high <= 0.0 || radius == 0.0) {
    e.aa = e.bb = e.ab = 0.0;
    return;
  }
  // high · v vᵀ with v the eigenvector of the larger eigenvalue.
  const double share = 0.5 * (1.0 + half / radius);
  const double mixed = 0.5 * e.ab / radius;
  e.aa = high * share;
  e.bb = high * (1.0 - share);
  e.ab = high * mixed;
}

}  // namespace

FramedArea framedArea(double A, double epsilon) {
  const double r = std::sqrt(A * A + epsilon);
  if (!(r > 0.0)) return {0.0, 0.0, 0.0};
  return {A * r, (2.0 * A * A + epsilon) / r, A * (2.0 * A * A + 3.0 * epsilon) / (r * r * r)};
}

double barrierValue(double N, double D, double scaleWeight, double epsilon) {
  return (N + scaleWeight * (D * D + 1.0)) / chi(D, epsilon);
}

Eigen::Matrix4d freeModel(double a, double b, double scaleWeight, double epsilon,
                          Eigen::Vector4d& slope) {
  FaceEnergy e = faceEnergy(a, b, scaleWeight, epsilon);
  slope << e.slopeA * a, 0.0, e.slopeB * b, 0.0;
  makeConvex(e);
  Eigen::Matrix4d M = Eigen::Matrix4d::Zero();
  M(0, 0) = e.aa;
  M(0, 2) = M(2, 0) = e.ab;
  M(2, 2) = e.bb;
  M(1, 1) = e.slopeA;
  M(3, 3) = e.slopeB;
  return M;
}

Eigen::Matrix4d framedModel(Complex similar, double b, double scaleWeight, double epsilon,
                            Eigen::Vector4d& slope) {
  const double A = similar.real(), T = similar.imag();
  const FramedArea P = framedArea(A, epsilon);
  const double D = P.value - b * b, N = A * A + T * T + b * b;
  const double s = std::sqrt(D * D + epsilon * epsilon), x = chi(D, epsilon);
  const double M0 = N + scaleWeight * (D * D + 1.0);
  const double FN = 1.0 / x, fnd = -1.0 / (x * s);
  const double FD = 2.0 * scaleWeight * D / x - M0 / (x * s);
  const double fdd =
      2.0 * scaleWeight / x - 4.0 * scaleWeight * D / (x * s) + 2.0 * M0 / (s * s * s);
  slope << 2.0 * A * FN + P.slope * FD, 2.0 * T * FN, 2.0 * b * (FN - FD), 0.0;
  Eigen::Matrix3d H;
  H(0, 0) = 2.0 * FN + 4.0 * A * P.slope * fnd + P.slope * P.slope * fdd + P.curvature * FD;
  H(1, 1) = 2.0 * FN;
  H(2, 2) = 2.0 * (FN - FD) + 4.0 * b * b * (-2.0 * fnd + fdd);
  H(0, 1) = H(1, 0) = 2.0 * P.slope * T * fnd;
  H(0, 2) = H(2, 0) = 2.0 * b * ((P.slope - 2.0 * A) * fnd - P.slope * fdd);
  H(1, 2) = H(2, 1) = -4.0 * T * b * fnd;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(H);
  const Eigen::Vector3d values = eigen.eigenvalues().cwiseMax(0.0);
  Eigen::Matrix4d M = Eigen::Matrix4d::Zero();
  M.topLeftCorner<3, 3>() =
      eigen.eigenvectors() * values.asDiagonal() * eigen.eigenvectors().transpose();
  M(3, 3) = std::max(2.0 * (FN - FD), 0.0);
  return M;
}

}  // namespace hgp
