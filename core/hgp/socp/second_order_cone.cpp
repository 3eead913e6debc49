#include "hgp/socp/second_order_cone.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "hgp/base/portable_math.h"

namespace hgp::socp {
namespace {

Vector3 reflect(const Vector3& s) { return {s[0], -s[1], -s[2]}; }

/// β (2 v vᵀ − J)
Matrix3 hyperbolic(double beta, const Vector3& v) {
  Matrix3 m = 2.0 * v * v.transpose();
  m(0, 0) -= 1.0;
  m(1, 1) += 1.0;
  m(2, 2) += 1.0;
  return beta * m;
}

}  // namespace

double determinant(const Vector3& s) {
  const double radius = portable::hypot(s[1], s[2]);
  return (s[0] - radius) * (s[0] + radius);
}

double depth(const Vector3& s) { return s[0] - portable::hypot(s[1], s[2]); }

Vector3 product(const Vector3& a, const Vector3& b) {
  return {a.dot(b), a[0] * b[1] + b[0] * a[1], a[0] * b[2] + b[0] * a[2]};
}

Vector3 divide(const Vector3& lambda, const Vector3& b) {
  const double first =
      (lambda[0] * b[0] - lambda[1] * b[1] - lambda[2] * b[2]) / determinant(lambda);
  return {first, (b[1] - first * lambda[1]) / lambda[0], (b[2] - first * lambda[2]) / lambda[0]};
}

double stepLength(const Vector3& s, const Vector3& ds) {
  // depth(s + α ds) = 0: a quadratic in α whose smallest positive root ends the step.
  const double a = ds[0] * ds[0] - ds[1] * ds[1] - ds[2] * ds[2];
  const double b = s[0] * ds[0] - s[1] * ds[1] - s[2] * ds[2];
  const double c = std::max(determinant(s), 0.0);
  double alpha = 1.0;
  if (ds[0] < 0.0) alpha = std::min(alpha, -s[0] / ds[0]);
  const double discriminant = b * b - a * c;
  if (discriminant >= 0.0) {
    const double root = std::sqrt(discriminant);
    // Roots of a α² + 2 b α + c, in the form that does not cancel.
    const double t = -(b + (b >= 0.0 ? root : -root));
    for (const double candidate : {a != 0.0 ? t / a : -1.0, t != 0.0 ? c / t : -1.0})
      if (candidate > 0.0) alpha = std::min(alpha, candidate);
  }
  return alpha;
}

Scaling ntScaling(const Vector3& s, const Vector3& y) {
  const double ds = std::sqrt(determinant(s)), dy = std::sqrt(determinant(y));
  const Vector3 unitS = s / ds, unitY = y / dy;
  const double gamma = std::sqrt(0.5 * (1.0 + unitS.dot(unitY)));
  const Vector3 w = (unitS + reflect(unitY)) / (2.0 * gamma);
  Vector3 v = w;
  v[0] += 1.0;
  v /= std::sqrt(2.0 * (w[0] + 1.0));
  const double beta = std::sqrt(ds / dy);
  Scaling scaling;
  scaling.W = hyperbolic(beta, v);
  scaling.inverse = hyperbolic(1.0 / beta, reflect(v));
  scaling.lambda = scaling.W * y;
  return scaling;
}

}  // namespace hgp::socp
