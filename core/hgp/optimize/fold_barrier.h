// The foldover-free energy of one triangle [GKK21] and the quadratic model that a Newton step minimises.
// Role: one term of untangle().
#pragma once

#include <Eigen/Core>

#include "hgp/base/turns.h"

namespace hgp {

/// (N + λ (D² + 1)) / χ(D, ε) with χ = ½ (D + √(D² + ε²)); N = |f_z|² + |f_z̄|².
double barrierValue(double N, double D, double scaleWeight, double epsilon);

/// Its gradient and its Hessian, clamped to positive semidefinite, for D = |f_z|² − |f_z̄|², in the radial
/// and tangential parts of f_z, then of f_z̄.
/// @param a  |f_z|
/// @param b  |f_z̄|
Eigen::Matrix4d freeModel(double a, double b, double scaleWeight, double epsilon,
                          Eigen::Vector4d& slope);

/// P(A) = A √(A² + ε) and its derivatives: A|A| for ε → 0, but with a slope at A = 0, so that collapsed triangles open.
struct FramedArea {
  double value, slope, curvature;
};
FramedArea framedArea(double A, double epsilon);

/// The same for D = P(A) − |f_z̄|², A = Re(f_z d̄), in (Re, Im) of f_z d̄ and the radial and tangential
/// part of f_z̄: positive D is then the frame condition [BCW17 (13)] without its margin.
/// @param similar  f_z d̄
Eigen::Matrix4d framedModel(Complex similar, double b, double scaleWeight, double epsilon,
                            Eigen::Vector4d& slope);

}  // namespace hgp
