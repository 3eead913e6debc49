// Builds a sparse matrix row by row.  Role: rows are short sums, so that no triplets need sorting.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "hgp/base/turns.h"

namespace hgp {

/// Moved without a copy, which Eigen 3.4 makes of a sparse matrix.
class SparseRows : public Eigen::SparseMatrix<Complex, Eigen::RowMajor> {
 public:
  using Matrix = Eigen::SparseMatrix<Complex, Eigen::RowMajor>;
  using Matrix::Matrix;
  SparseRows() = default;
  SparseRows(const SparseRows&) = default;
  SparseRows& operator=(const SparseRows&) = default;
  SparseRows(SparseRows&& other) noexcept { swap(other); }
  SparseRows& operator=(SparseRows&& other) noexcept {
    swap(other);
    return *this;
  }
};

/// Terms with the same column are added in the order of the calls; the columns of each finished row ascend.
class RowBuilder {
 public:
  RowBuilder(int columns, int expectedRows, std::size_t expectedEntries);

  void add(int column, const Complex& value);
  /// Ends the row; sums with an absolute value of at most `noise` are left out (none if it is negative).
  void endRow(double noise);
  /// All rows so far; leaves the builder empty.
  SparseRows take();

 private:
  struct Term {
    int column;
    Complex value;
  };
  std::vector<int> index_;  // column → index into row_, valid if that entry has this column
  std::vector<Term> row_;
  std::vector<int> start_{0};
  SparseRows::Storage entries_;
};

}  // namespace hgp
