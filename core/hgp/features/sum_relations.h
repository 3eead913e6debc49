// Exact solution of homogeneous relations between real numbers with small integer coefficients.  Role: loops of
// features relate components of translations; the relations hold in the stored numbers, without rounding.
#pragma once

#include <map>
#include <optional>
#include <vector>

namespace hgp {

/// Σ factor · variable; factors are exact: multiples of 1/kFactorSteps below kLargestFactor.
using RealSum = std::map<int, double>;
inline constexpr double kFactorSteps = 16.0, kLargestFactor = 1e6;
bool isExactFactor(double x);

void addTo(RealSum& sum, const RealSum& other, double factor);

/// Solves Σ factor · variable = 0 for every sum: each eliminates one variable, one that divides the others of its sum
/// and occurs in few sums. Redundant sums are dropped.
/// @return  per variable that is not free, its sum over free ones; nothing where a factor would not be exact
std::optional<std::map<int, RealSum>> solveSums(std::vector<RealSum> relations);

}  // namespace hgp
