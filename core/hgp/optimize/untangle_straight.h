// Untangling along features.  Role: maps whose frames contradict each other, the lengths or the integers of a grid.
#pragma once

#include "hgp/optimize/straight_program.h"
#include "hgp/optimize/untangler.h"

namespace hgp {

struct StraightUntangling {
  Eigen::VectorXd x;       ///< the unknowns
  std::vector<Complex> z;  ///< per copy
  int iterations = 0;
  int flipped = 0;  ///< as UntangleResult::flipped
  bool isCancelled = false;
};

/// untangle() over the real unknowns, which keep features straight.
/// @param x      the initial unknowns
/// @param given  the unknowns that keep their values
/// @param frameAngle  as SeamRotations::frameAngle
StraightUntangling untangleStraight(const StraightSystem& straight, const Eigen::VectorXd& x,
                                    const std::vector<std::pair<int, double>>& given,
                                    const PerFace<double>& frameAngle,
                                    const UntangleOptions& options);

}  // namespace hgp
