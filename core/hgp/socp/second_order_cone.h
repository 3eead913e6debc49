// Algebra of the cone Q³ and its Nesterov–Todd scaling.  Role: everything the interior-point loop
// needs of a constraint (notation of Vandenberghe, "The CVXOPT linear and quadratic cone program
// solvers", 2010, §4).
#pragma once

#include <Eigen/Core>

namespace hgp::socp {

using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;

/// s₀² − s₁² − s₂², without cancellation.
double determinant(const Vector3& s);
/// Distance-like measure: s₀ − √(s₁² + s₂²); positive inside.
double depth(const Vector3& s);
/// a ∘ b = (aᵀb, a₀b₁ + b₀a₁, …).
Vector3 product(const Vector3& a, const Vector3& b);
/// The x with λ ∘ x = b, for λ inside the cone.
Vector3 divide(const Vector3& lambda, const Vector3& b);
/// Largest α ≤ 1 such that s + α ds stays in the cone.
double stepLength(const Vector3& s, const Vector3& ds);

/// W with W y = W⁻¹ s = λ, for s and y inside the cone: W = β (2 v vᵀ − J).
struct Scaling {
  Matrix3 W;
  Matrix3 inverse;
  Vector3 lambda;
};
Scaling ntScaling(const Vector3& s, const Vector3& y);

}  // namespace hgp::socp
