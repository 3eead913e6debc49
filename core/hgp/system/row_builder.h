// Sparse rows appended one after another.  Role: rows made of short sums, without sorting triplets.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "hgp/base/turns.h"

namespace hgp {

using SparseRows = Eigen::SparseMatrix<Complex, Eigen::RowMajor>;

/// Terms of one column add up in the order they come; a row's columns ascend in the end.
class RowBuilder {
 public:
  RowBuilder(int columns, int expectedRows, std::size_t expectedEntries);

  void add(int column, const Complex& value);
  /// Ends the row; sums that are not above `noise` are left out.
  void endRow(double noise);
  /// All rows so far; leaves the builder empty.
  SparseRows take();

 private:
  struct Term {
    int column;
    Complex value;
  };
  std::vector<int> place_;  // column → index into row_, valid where that one has this column
  std::vector<Term> row_;
  std::vector<int> start_{0}, column_;
  std::vector<Complex> value_;
};

}  // namespace hgp
