// Where the interior-point method starts.
#pragma once

#include "hgp/socp/newton_system.h"

namespace hgp::socp {

struct Start {
  Iterate point;
  bool isFree = false;  ///< no constraint binds: the minimiser of the objective alone, y = 0
};

/// The minimiser without constraints where it fulfils them all within the targets. Otherwise the
/// minimiser of the objective + ½ρ|F x − h|² with s and y = −ρs pushed into the cone. ρ is what the
/// objective itself resists a change of F x with, xᵀHx / |F x|² at the minimiser without constraints, so
/// that s and y start at their own scales; it grows where that minimiser is far outside the cones.
Start startingPoint(const Problem& problem, const SolveOptions& targets, NewtonSystem& system);

}  // namespace hgp::socp
