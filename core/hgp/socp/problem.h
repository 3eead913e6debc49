// A convex quadratic program with second-order cones of dimension 3.  Role: standard form of
// [BCW17 (11)–(13)] after elimination of the unknowns that no frame condition contains.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "hgp/linalg/factor/factor.h"

namespace hgp::socp {

/// s = F x − h must lie in Q³ = {(s₀, s₁, s₂): s₀ ≥ √(s₁² + s₂²)}.
struct ConeConstraint {
  /// Complex unknowns of the reduced problem; unknown j is the pair x[2j], x[2j + 1].
  std::vector<int> unknowns;
  Eigen::Matrix<double, 3, Eigen::Dynamic> F;  ///< 3 × 2·|unknowns|
  Eigen::Vector3d h = Eigen::Vector3d::Zero();
};

/// minimise ½ xᵀ H x + cᵀ x  subject to  F_b x − h_b ∈ Q³ for all b.
///
/// H is the reduced form of `form`, whose cliques are the constraints' unknowns in the same order.
struct Problem {
  linalg::ChangingForm* form = nullptr;
  Eigen::VectorXd c;  ///< two numbers per unknown of the form
  std::vector<ConeConstraint> constraints;
  /// All constraints have the same unknowns in the same order, and `form` has one clique for all of them.
  bool sharesBlock = false;
};

/// c of the reduced problem of ½ xᴴ H x + Re(cᴴ x): two numbers per unknown that the form leaves.
Eigen::VectorXd reducedLinear(const linalg::PartialCholesky& form, const Eigen::VectorXcd& c);
/// This problem, without constraints yet. @pre the form outlives it
Problem problemOver(linalg::PartialCholesky& form, const Eigen::VectorXcd& c);
/// Appends a constraint on these unknowns of H, which are those of the form's next clique.
void append(ConeConstraint constraint, const std::vector<int>& unknowns,
            const linalg::PartialCholesky& form, Problem& problem);

struct SolveOptions {
  int maxIterations = 60;
  double primal = 1e-5;  ///< target of max |F x − s − h| / max |h|
  double dual =
      1e-5;  ///< target of |H x + c − Fᵀy| relative to its largest term; rounding leaves 1e-7
  double gap = 1e-5;  ///< target of sᵀy against the objective's scale
  /// Called every iteration with (iteration, largest residual / target); false cancels.
  std::function<bool(int, double)> progress;
};

enum class SolveStatus {
  kOptimal,     ///< all residuals and the gap below their targets
  kAlmost,      ///< no further progress close to the targets; the caller must check the point
  kInfeasible,  ///< the constraints contradict each other: y proves it (provesInfeasible in iterate.h)
  /// F x − s − h has not shrunk for some iterations, which is what contradicting constraints do; nothing is proven.
  kNoProgress,
  kStalled,  ///< steps became too short, or the factorization failed
  kIterationLimit,
  kCancelled,
};
const char* statusName(SolveStatus status);
/// Whether the iterate is far from fulfilling the constraints, and nothing can be learned from it.
inline bool isWithoutPoint(SolveStatus status) {
  return status == SolveStatus::kInfeasible || status == SolveStatus::kNoProgress;
}

/// The last or best iterate, whatever the status.
struct Solution {
  Eigen::VectorXd x;
  std::vector<Eigen::Vector3d>
      y;  ///< duals; the largest belong to the constraints that are strained most
  SolveStatus status = SolveStatus::kStalled;
  int iterations = 0;
  bool isFree = false;          ///< no constraint binds: the minimiser of the objective alone
  double primalResidual = 0.0;  ///< max |F x − s − h| relative to max |h|
  double dualResidual = 0.0;    ///< relative
  double gap = 0.0;             ///< sᵀy relative to the objective's scale
};

}  // namespace hgp::socp
