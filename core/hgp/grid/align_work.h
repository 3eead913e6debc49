// What the steps of an alignment cost, in multiply-adds.  Role: the budget of align.cpp.
#pragma once

#include <algorithm>
#include <cstddef>

#include "hgp/base/portable_math.h"

namespace hgp {

/// Fraction of all work that is reserved for finding a number of cells that works.
inline constexpr double kExplaining = 0.15;
/// Fraction of all work that is reserved for repairs, however long the choice of many integers took.
inline constexpr double kRepairShare = 0.25;
/// Per triangle: verifying a map.
inline constexpr double kVerifyWork = 3e3;
/// Per triangle: a linear step apart from its back-substitution (copies, exact orientation).
inline constexpr double kStepWork = 1200.0;
/// Of that, if only cells are counted.
inline constexpr double kCountShare = 0.3;
/// The choice of k integers, divided by k³; most of it separates close cones (measured).
inline constexpr double kRoundingWork = 1.5;
/// One factorization of a program over n triangles, divided by n^(3/2), and the rest of an iteration, divided by n
/// (measured).
inline constexpr double kPlanarWork = 22.0;
inline constexpr double kProgramWork = 3e3;
/// Interior-point iterations that a program is expected to need.
inline constexpr int kExpectedIterations = 14;

/// A linear step that solves with this work and chooses so many integers.
inline double linearStepWork(int triangles, double solve, int integers) {
  const double k = integers;
  return kStepWork * triangles + solve + kRoundingWork * k * k * k;
}

/// A program over this many triangles with conditions on `bound` of them, as expected.
inline double programWork(std::size_t triangles, std::size_t bound) {
  // Elimination of a planar system of n unknowns costs O(n^(3/2)); real pairs cost twice as much as complex unknowns.
  const auto planar = [](std::size_t n) {
    return kPlanarWork * portable::pow(static_cast<double>(n), 1.5);
  };
  return kProgramWork * static_cast<double>(triangles) + 0.5 * planar(triangles) +
         kExpectedIterations * planar(std::min(triangles, bound));
}

}  // namespace hgp
