// The changing part of a partial Cholesky factorization: real fronts, assembled and factored again.  Role: the cost
// of an interior-point iteration.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <complex>
#include <vector>

#include "hgp/linalg/factor/panel_factor.h"

namespace hgp::linalg {

/// K = real(H̃) + Σ_b E_bᵀ D_b E_b on the dynamic unknowns, numbered 0 … count − 1 by elimination
/// position; unknown d is the real pair (2d, 2d + 1). H̃ is kept as the entries of H between dynamic
/// unknowns plus one dense Hermitian block ("block") per static subtree: its Schur complement.
class ReducedSystem {
 public:
  using ComplexSparse = Eigen::SparseMatrix<std::complex<double>>;

  /// Takes ownership of the complements left by the static elimination (by node of `full`).
  void build(const SymbolicFactor& full, const ComplexSparse& H, const Cliques& cliques,
             std::vector<Contribution<std::complex<double>>> complements);

  int count() const { return static_cast<int>(position_.size()); }
  /// Elimination position of dynamic unknown d in the full problem.
  int position(int d) const { return position_[d]; }
  /// The inverse by position; −1 for static ones.
  int indexAt(int position) const { return index_[position]; }

  /// Block b's 2m × 2m numbers start at values[offset(b)], column-major; offset(blocks) is the total.
  std::size_t offset(int b) const { return offset_[b]; }
  std::size_t storage() const { return offset_.back(); }
  int blockCount() const { return static_cast<int>(offset_.size()) - 1; }

  Eigen::VectorXcd apply(const Eigen::VectorXcd& x) const;
  /// H̃ in full, both triangles.
  Eigen::MatrixXcd dense() const;
  /// badPivot of the status is a dynamic unknown.
  FactorStatus factor(const double* values);
  void solveInPlace(Eigen::Ref<Eigen::MatrixXd> x) const;
  bool isFactored() const { return panels_.isReady(); }
  FactorCost cost() const { return factorCost(*symbolic_); }

 private:
  using Complex = std::complex<double>;
  struct SchurBlock {
    std::vector<int> index;   // dynamic unknowns, ascending
    Eigen::MatrixXcd values;  // lower triangle
  };
  struct Entry {
    int target;  // offset within the panel of its node
    int source;  // index into the numbers it comes from
  };
  /// Entries grouped by node.
  struct EntryList {
    std::vector<std::size_t> start;
    std::vector<Entry> entries;
  };
  struct Coordinate {
    int row, column, source;  // real positions, row ≥ column
  };

  void numberUnknowns(const SymbolicFactor& full);
  void doubleSymbolic(const SymbolicFactor& full);
  void takeMatrix(const SymbolicFactor& full, const ComplexSparse& H);
  void takeComplements(const SymbolicFactor& full,
                       std::vector<Contribution<std::complex<double>>> complements);
  void mergeBlocks(std::vector<SchurBlock>* blocks) const;
  void takeCliques(const SymbolicFactor& full, const Cliques& cliques);
  EntryList entryList(const std::vector<Coordinate>& coordinates) const;
  void fillPanel(int t, const int* local, double* panel, int rows, const double* values,
                 double lift) const;
  void addPieces(int t, const int* local, double* panel, double* complement) const;

  std::vector<int> position_, index_, nodeOf_;  // nodeOf_: dynamic node of each dynamic unknown
  std::vector<int> nodeName_;  // node of the full factor → dynamic node, −1 if static
  std::shared_ptr<SymbolicFactor> symbolic_;     // of the doubled real problem
  ComplexSparse H_;                              // between dynamic unknowns, both triangles
  std::vector<std::vector<SchurBlock>> blocks_;  // by dynamic node
  std::vector<double> matrixValues_;
  EntryList matrixEntries_, blockEntries_;
  std::vector<std::size_t> offset_{0};
  std::vector<double> matrixDiagonal_, diagonal_;
  std::vector<std::pair<int, int>> blockDiagonal_;  // real position, index of the number
  PanelFactor<double> panels_;
};

}  // namespace hgp::linalg
