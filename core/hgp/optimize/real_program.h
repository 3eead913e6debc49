// A convex program over real unknowns with many constraints of which few bind.  Role: solves those of maps along features
// (straight_program.h).
#pragma once

#include <Eigen/SparseCore>
#include <functional>
#include <vector>

#include "hgp/linalg/ordering/ordering.h"
#include "hgp/socp/problem.h"

namespace hgp {

/// minimise ½ xᵀ H x + cᵀ x  subject to  F_b x − h_b ∈ Q³ for all b,  over n unknowns, n even.
struct RealProgram {
  Eigen::SparseMatrix<double> H;  ///< positive definite; both triangles
  Eigen::VectorXd c;
  std::vector<socp::ConeConstraint> constraints;  ///< over pairs of unknowns, ascending
};

struct RealSolution {
  socp::Solution solution;    ///< with duals for all constraints: 0 for those that were left out
  double multiplyAdds = 0.0;  ///< of the factorizations
};

/// The minimiser without constraints comes first; then those that it violates, or nearly so, are taken into the program until no
/// other is violated. As the objective is strictly convex, what is left out changes nothing. A part that is proved infeasible
/// proves it for all; one that ends otherwise without a point is followed by the program with all constraints.
/// @param tree  orders the unknowns
RealSolution solveReal(const RealProgram& program, const linalg::SeparatorTree& tree,
                       const std::function<bool(int, double)>& progress);

}  // namespace hgp
