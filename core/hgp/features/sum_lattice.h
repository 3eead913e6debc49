// Numbers of which given sums are integers.  Role: lines, translations and cones of a map on a grid: which values of its
// real unknowns put all of them on grid points.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "hgp/features/sum_relations.h"

namespace hgp {

/// The lattice {x : Σ factor · x ∈ ℤ for every sum}, as x = B⁻¹ y, y ∈ ℤⁿ. The rows of B generate the same sums over ℤ;
/// they are kept in echelon form, so that B is triangular.
class SumLattice {
 public:
  /// Adds a sum, if it is not an integer combination of the others.
  /// @return false where integers grow beyond what is exact; the lattice is then of no use
  bool add(const RealSum& sum);

  /// Chooses rows with small factors: what is near integers in one row is not far from them in another.
  void reduce();
  /// Whether integers determine every variable that occurs.
  bool isComplete() const;
  /// Those that occur, ascending; after isComplete().
  std::vector<int> variables() const;
  /// B, |variables| × |variables|, upper triangular.
  Eigen::MatrixXd basis() const;

 private:
  using Row = std::map<int, std::int64_t>;  ///< factors in steps of 1/kFactorSteps
  static bool subtract(Row& row, const Row& other, std::int64_t times);
  /// Takes multiples of the rows of variables after the first from it, so that no entry exceeds half of the first one in
  /// its column.
  void shorten(Row& row, int first) const;
  std::map<int, Row> rows_;  ///< by their first variable
};

}  // namespace hgp
