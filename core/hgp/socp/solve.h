// Primal–dual interior-point method for Problem.  Role: solves the program [BCW17 (11)–(13)]; each
// iteration is one factorization of the small part that changes and two solves.
#pragma once

#include "hgp/socp/problem.h"

namespace hgp::socp {

/// If no constraint is active at the minimiser, it is returned at once, with zero iterations and zero duals.
/// Otherwise Mehrotra's predictor–corrector method with Nesterov–Todd scaling. Never throws on bad
/// numbers: an infeasible or badly scaled program ends with its best iterate and a status.
Solution solve(const Problem& problem, const SolveOptions& options = {});

/// F_b x − h_b ∈ Q³ for all b.
bool isFulfilled(const Problem& problem, const Eigen::VectorXd& x);

}  // namespace hgp::socp
