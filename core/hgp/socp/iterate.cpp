#include "hgp/socp/iterate.h"

#include <algorithm>

namespace hgp::socp {
namespace {

/// Conjugate gradients of withoutPull: relative decrease at which they end, and their maximum number.
constexpr double kPullShare = 1e-12;
constexpr int kPullSteps = 300;

}  // namespace

Vector3 image(const ConeConstraint& constraint, const Eigen::VectorXd& x) {
  Vector3 r = Vector3::Zero();
  for (std::size_t i = 0; i < constraint.unknowns.size(); ++i) {
    const auto column = static_cast<Eigen::Index>(2 * i);
    r += constraint.F.middleCols<2>(column) * x.segment<2>(2 * constraint.unknowns[i]);
  }
  return r;
}

void addTransposed(const ConeConstraint& constraint, const Vector3& v, double factor,
                   Eigen::VectorXd& out) {
  for (std::size_t i = 0; i < constraint.unknowns.size(); ++i) {
    const auto column = static_cast<Eigen::Index>(2 * i);
    out.segment<2>(2 * constraint.unknowns[i]) +=
        factor * constraint.F.middleCols<2>(column).transpose() * v;
  }
}

double offsetScale(const Problem& problem) {
  double scale = 0.0;
  for (const ConeConstraint& b : problem.constraints) scale = std::max(scale, b.h.norm());
  return scale == 0.0 ? 1.0 : scale;
}

Residuals residualsAt(const Problem& problem, const Iterate& point, double scaleH) {
  const std::size_t count = problem.constraints.size();
  Residuals r;
  const Eigen::VectorXd Hx = problem.form->apply(point.x);
  r.x = Hx + problem.c;
  Eigen::VectorXd pull = Eigen::VectorXd::Zero(r.x.size());
  r.s.resize(count);
  for (std::size_t b = 0; b < count; ++b) {
    const ConeConstraint& constraint = problem.constraints[b];
    addTransposed(constraint, point.y[b], -1.0, pull);
    r.s[b] = point.s[b] - image(constraint, point.x) + constraint.h;
    r.primal = std::max(r.primal, r.s[b].norm() / scaleH);
    r.complement += point.s[b].dot(point.y[b]);
  }
  const double scale = std::max({Hx.norm(), problem.c.norm(), pull.norm(), 1e-300});
  r.x += pull;
  r.dual = r.x.norm() / scale;
  r.mu = count ? r.complement / static_cast<double>(count) : 0.0;
  r.objective = 0.5 * point.x.dot(Hx) + problem.c.dot(point.x);
  return r;
}

bool provesInfeasible(const Problem& problem, const Slacks& y, double scaleH, double share) {
  Eigen::VectorXd pull = Eigen::VectorXd::Zero(problem.c.size());
  double gain = 0.0, size = 0.0;
  for (std::size_t b = 0; b < y.size(); ++b) {
    addTransposed(problem.constraints[b], y[b], 1.0, pull);
    gain += problem.constraints[b].h.dot(y[b]);
    size += scaleH * y[b].norm();
  }
  return gain > share * size && scaleH * pull.norm() <= share * gain;
}

Slacks withoutPull(const Problem& problem, Slacks y) {
  const auto transposed = [&](const Slacks& v) {
    Eigen::VectorXd out = Eigen::VectorXd::Zero(problem.c.size());
    for (std::size_t b = 0; b < v.size(); ++b)
      addTransposed(problem.constraints[b], v[b], 1.0, out);
    return out;
  };
  Eigen::VectorXd pull = transposed(y), direction = pull;
  double square = pull.squaredNorm();
  const double target = kPullShare * kPullShare * square;
  Slacks step(y.size());
  for (int n = 0; n < kPullSteps && square > target && square > 0.0; ++n) {
    double length = 0.0;
    for (std::size_t b = 0; b < y.size(); ++b) {
      step[b] = Vector3::Zero();
      if (y[b] != Vector3::Zero()) step[b] = image(problem.constraints[b], direction);
      length += step[b].squaredNorm();
    }
    if (!(length > 0.0)) break;
    const double alpha = square / length;
    for (std::size_t b = 0; b < y.size(); ++b) y[b] -= alpha * step[b];
    pull = transposed(y);
    const double next = pull.squaredNorm();
    direction = pull + next / square * direction;
    square = next;
  }
  return y;
}

}  // namespace hgp::socp
