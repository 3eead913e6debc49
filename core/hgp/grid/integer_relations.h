// Solves homogeneous linear relations over Z[i] in integers.  Role: finds the translations of seams that
// can be chosen freely so that all translations are integers.
#pragma once

#include <optional>
#include <vector>

#include "hgp/grid/gaussian.h"

namespace hgp {

struct GaussianTerm {
  int variable = 0;
  Gaussian factor;
};
/// Σ factor · variable.
using GaussianSum = std::vector<GaussianTerm>;

/// All integer solutions t ∈ Z[i]ⁿ of the relations: t = B y with y ∈ Z[i]ᵏ arbitrary and unique.
struct IntegerBasis {
  std::vector<GaussianSum> value;       ///< row of B per variable: in terms of y
  std::vector<GaussianSum> coordinate;  ///< y_j in terms of the variables
  int size() const { return static_cast<int>(coordinate.size()); }
};

/// Gauss–Jordan with unit pivots; rows are divided by their content, and a row without a unit is
/// brought to one by Euclid's algorithm on the variables. Redundant relations are dropped.
/// @return nothing where a coefficient grows beyond 2³⁰ (has not occurred on seams)
std::optional<IntegerBasis> solveRelations(int variableCount,
                                           const std::vector<GaussianSum>& relations);

}  // namespace hgp
