#include "hgp/socp/start.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace hgp::socp {
namespace {

/// If the start is outside a cone by more than this multiple of |h|, ρ is increased, which moves it towards the cones.
constexpr double kFarOutside = 30.0;

struct Unconstrained {
  std::optional<Iterate> point;  ///< set if it satisfies all constraints
  double stiffness = 1.0;        ///< xᵀHx / |F x|²
};

Unconstrained minimiser(const Problem& problem, const SolveOptions& targets, double scaleH,
                        NewtonSystem& system) {
  Unconstrained result;
  const std::size_t count = problem.constraints.size();
  if (count == 0 || !system.factorUniform(0.0)) return result;
  Iterate point;
  point.x = system.solve(Eigen::VectorXd(-problem.c));
  if (!point.x.allFinite()) return result;
  point.s.resize(count);
  bool isInside = true;
  double squares = 0.0;
  for (std::size_t b = 0; b < count; ++b) {
    point.s[b] = image(problem.constraints[b], point.x);
    squares += point.s[b].squaredNorm();
    point.s[b] -= problem.constraints[b].h;
    isInside = isInside && depth(point.s[b]) >= 0.0;
  }
  const double stiffness = point.x.dot(problem.form->apply(point.x)) / squares;
  if (std::isfinite(stiffness) && stiffness > 0.0) result.stiffness = stiffness;
  point.y.assign(count, Vector3::Zero());
  if (!isInside) return result;
  const Residuals r = residualsAt(problem, point, scaleH);
  if (r.primal <= targets.primal && r.dual <= targets.dual) result.point = std::move(point);
  return result;
}

/// The starting point for this ρ; `miss` is the distance by which s had to be moved into the cones.
Iterate drawnCloser(const Problem& problem, NewtonSystem& system, double rho, double scaleH,
                    double& miss) {
  const std::size_t count = problem.constraints.size();
  Eigen::VectorXd rhs = -problem.c;
  for (const ConeConstraint& b : problem.constraints) addTransposed(b, b.h, rho, rhs);
  Iterate point;
  point.x = Eigen::VectorXd::Zero(problem.c.size());
  if (system.factorUniform(rho)) point.x = system.solve(rhs);
  if (!point.x.allFinite()) point.x.setZero();
  point.s.resize(count);
  point.y.resize(count);
  double needS = 0.0, needY = 0.0;
  for (std::size_t b = 0; b < count; ++b) {
    point.s[b] = image(problem.constraints[b], point.x) - problem.constraints[b].h;
    point.y[b] = -rho * point.s[b];
    needS = std::max(needS, -depth(point.s[b]));
    needY = std::max(needY, -depth(point.y[b]));
  }
  for (std::size_t b = 0; b < count; ++b) {
    point.s[b][0] += needS + scaleH;
    point.y[b][0] += needY + rho * scaleH;
  }
  miss = needS;
  return point;
}

}  // namespace

Start startingPoint(const Problem& problem, const SolveOptions& targets, NewtonSystem& system) {
  const double scaleH = offsetScale(problem);
  Unconstrained free = minimiser(problem, targets, scaleH, system);
  if (free.point) return {std::move(*free.point), true};
  double rho = std::clamp(free.stiffness, 1e-8, 1.0), miss = 0.0;
  Iterate point = drawnCloser(problem, system, rho, scaleH, miss);
  while (miss > kFarOutside * scaleH && rho < 1.0) {
    rho = std::min(1.0, 100.0 * rho);
    point = drawnCloser(problem, system, rho, scaleH, miss);
  }
  return {std::move(point), false};
}

}  // namespace hgp::socp
