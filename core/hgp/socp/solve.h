// Primal–dual interior-point method for Problem.  Role: our own solver of [BCW17 (11)–(13)]; each
// iteration is one factorization of the small changing part and two solves.
#pragma once

#include <functional>

#include "hgp/socp/problem.h"

namespace hgp::socp {

struct SolveOptions {
  int maxIterations = 60;
  double primal = 1e-8;  ///< target of max |F x − s − h| / max |h|
  double dual =
      1e-5;  ///< target of |H x + c − Fᵀy| relative to its largest term; rounding leaves 1e-7
  double gap = 1e-6;  ///< target of sᵀy against the objective's scale
  /// Called every iteration with (iteration, largest residual / target); false cancels.
  std::function<bool(int, double)> progress;
};

/// Mehrotra's predictor–corrector with Nesterov–Todd scaling. Starts anywhere; never throws on bad
/// numbers: an infeasible or badly scaled program ends with its best iterate and a status.
Solution solve(const Problem& problem, const SolveOptions& options = {});

}  // namespace hgp::socp
