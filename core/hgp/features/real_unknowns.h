// Real unknowns of a seamless map with straight features.  Role: equal coordinates are eliminated exactly, so that all
// values of the unknowns keep features on their lines; there is no penalty term.
#pragma once

#include <Eigen/SparseCore>
#include <optional>
#include <vector>

#include "hgp/base/turns.h"

namespace hgp {

/// Copies a and b have the same real part, or the same imaginary part.
struct EqualCoordinate {
  int a = 0, b = 0;
  bool isImaginary = false;
};

struct RealUnknowns {
  using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;
  int count = 0;
  /// 2|copies| × count: rows 2c and 2c + 1 are the real and the imaginary part of copy c. Rows of equal coordinates
  /// are equal, so that their products with any x have the same bits. Factors are exact (isExactFactor).
  Rows rows;
  std::vector<int>
      variable;  ///< per unknown: 2j or 2j + 1, the part of complex unknown j that it is; ascending
};

/// Parts of complex numbers: 2j is the real part of x_j, 2j + 1 the imaginary one.
Eigen::VectorXd partsOf(const Eigen::VectorXcd& x, const std::vector<int>& parts);
void setParts(const Eigen::VectorXd& values, const std::vector<int>& parts, Eigen::VectorXcd& x);

/// Copy by copy, from the values of the unknowns.
std::vector<Complex> placesOf(const RealUnknowns& unknowns, const Eigen::VectorXd& x);

/// Eliminates the equations from z = copies · x by union–find with signs and offsets over the parts of the vertices'
/// unknowns; what closed loops require of translations is solved in solveSums.
/// @param copies    |copies| × n, exact up to rounding errors
/// @param isShared  per complex unknown: 1 for translations, which occur in many rows
/// @return nothing where a factor is not exact
std::optional<RealUnknowns> equateCoordinates(
    const Eigen::SparseMatrix<Complex, Eigen::RowMajor>& copies, const std::vector<char>& isShared,
    const std::vector<EqualCoordinate>& equations);

}  // namespace hgp
