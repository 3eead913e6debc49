// A sparse matrix that is summed up from small dense ones many times.  Role: places are looked up once.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

namespace hgp {

/// H = Σ_i E_i K_i E_iᵀ: K_i acts on the unknowns of clique i. Every unknown is complex and has two rows, its real and
/// its imaginary part; the pattern of H is fixed by the cliques.
class CliqueSum {
 public:
  explicit CliqueSum(int unknownCount) : count_(unknownCount) {}

  /// The numbers of the unknowns of the next clique.
  void addClique(std::vector<int> unknowns) { cliques_.push_back(std::move(unknowns)); }
  /// Which unknowns have a common clique, without the diagonal: count × count.
  Eigen::SparseMatrix<double> couples() const;
  /// To be called once, after the last clique: finds the pattern and the places of all entries.
  void analyze();

  void setZero();
  /// Adds the matrices in the order of the cliques, beginning again after setZero().
  /// @param K  2n × 2n for a clique of n unknowns; row 2i belongs to the real part of unknown i
  void add(const Eigen::MatrixXd& K);

  Eigen::SparseMatrix<double>& matrix() { return H_; }

 private:
  int count_;
  std::vector<std::vector<int>> cliques_;
  Eigen::SparseMatrix<double> H_;
  std::vector<int> places_;  ///< in H_'s values: those of each clique's entries, column by column
  std::size_t next_ = 0;     ///< the place of the next entry
};

}  // namespace hgp
