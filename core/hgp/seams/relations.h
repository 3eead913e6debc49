// Linear relations between the translations of chains, solved exactly.  Role: the composed translation around a seam
// node without rotation vanishes [BCW17 §4, (12)]; what remains free are unknowns or, on a grid, integers.
#pragma once

#include <optional>
#include <vector>

#include "hgp/seams/copy_place.h"

namespace hgp {

/// Variables in terms of those that stay free: denominator · variable = Σ factor · free variable.
template <class Ring>
struct FreeVariables {
  struct Value {
    RingSum<Ring> sum;                ///< empty where the variable is free
    std::optional<Ring> denominator;  ///< none: 1
  };
  std::vector<char> isFree;  ///< by variable
  std::vector<Value> value;  ///< by variable
};

/// Solves Σ factor · variable = 0 for every given sum over the field of fractions: each eliminates one variable, one
/// with a unit coefficient where there is any. Redundant relations are dropped.
/// @pre seams: then at most one relation of a component has no unit, the last one
template <class Ring>
FreeVariables<Ring> eliminateRelations(int variableCount,
                                       const std::vector<RingSum<Ring>>& relations);

/// All solutions t ∈ Ringⁿ of the relations: t = B y with y ∈ Ringᵏ arbitrary and unique.
template <class Ring>
struct LatticeBasis {
  std::vector<RingSum<Ring>> value;       ///< row of B per variable: in terms of y
  std::vector<RingSum<Ring>> coordinate;  ///< y_j in terms of the variables
  int size() const { return static_cast<int>(coordinate.size()); }
};

/// The same elimination over a Euclidean ring, without fractions: a row without a unit is divided by its content and
/// brought to a unit by Euclid's algorithm on the variables.
/// @return nothing where a coefficient grows beyond 2³⁰ (has not occurred on seams)
template <class Ring>
std::optional<LatticeBasis<Ring>> solveRelations(int variableCount,
                                                 const std::vector<RingSum<Ring>>& relations);

using GaussianTerm = RingTerm<Gaussian>;
using GaussianSum = RingSum<Gaussian>;
using IntegerBasis = LatticeBasis<Gaussian>;

}  // namespace hgp
