// A primal–dual point of a Problem, and how far it is from a solution.  Role: the residuals that the
// interior-point loop evaluates before every step.
#pragma once

#include <vector>

#include "hgp/socp/problem.h"
#include "hgp/socp/second_order_cone.h"

namespace hgp::socp {

using Slacks = std::vector<Vector3>;

struct Iterate {
  Eigen::VectorXd x;
  Slacks s, y;  ///< per constraint: s = F x − h inside the cone, and its dual
};

/// F_b x
Vector3 image(const ConeConstraint& constraint, const Eigen::VectorXd& x);
/// out += factor · F_bᵀ v
void addTransposed(const ConeConstraint& constraint, const Vector3& v, double factor,
                   Eigen::VectorXd& out);

/// max |h|, 1 where that is 0: what primal residuals are relative to.
double offsetScale(const Problem& problem);

struct Residuals {
  Eigen::VectorXd x;        ///< H x + c − Fᵀy
  Slacks s;                 ///< s − F x + h
  double primal = 0.0;      ///< max |s − F x + h| / max |h|
  double dual = 0.0;        ///< |H x + c − Fᵀy| relative to its largest term
  double complement = 0.0;  ///< sᵀy
  double objective = 0.0;   ///< ½ xᵀH x + cᵀx
  double mu = 0.0;          ///< sᵀy per constraint
};
Residuals residualsAt(const Problem& problem, const Iterate& point, double scaleH);

/// Farkas: y in the cone with Fᵀy = 0 and hᵀy > 0 proves that no x has F x − h in the cone. Iterates only
/// converge to such a direction, so the test is relative: hᵀy > share·|h||y| and |h||Fᵀy| ≤ share·hᵀy.
bool provesInfeasible(const Problem& problem, const Slacks& y, double scaleH, double share);

/// y without its part along the columns of F, so that Fᵀy = 0 up to rounding: y − F w with the w of least squares
/// (conjugate gradients); only rows where y is not zero take part. Where the result is still in the cones, a y that
/// nearly proved infeasibility does prove it.
Slacks withoutPull(const Problem& problem, Slacks y);

}  // namespace hgp::socp
