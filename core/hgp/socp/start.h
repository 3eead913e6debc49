// The starting point of the interior-point method.
#pragma once

#include "hgp/socp/newton_system.h"

namespace hgp::socp {

struct Start {
  Iterate point;
  bool isFree = false;  ///< no constraint is active: the minimiser of the objective alone, y = 0
};

/// The unconstrained minimiser if it satisfies all constraints within the targets. Otherwise the
/// minimiser of the objective + ½ρ|F x − h|² with s and y = −ρs moved into the cone. ρ is the curvature of the
/// objective relative to F x, xᵀHx / |F x|² at the unconstrained minimiser, so
/// that s and y start at their own scales; it is increased where that minimiser is far outside the cones.
Start startingPoint(const Problem& problem, const SolveOptions& targets, NewtonSystem& system);

}  // namespace hgp::socp
