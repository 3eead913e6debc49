#include "hgp/optimize/clique_sum.h"

#include <algorithm>

namespace hgp {

Eigen::SparseMatrix<double> CliqueSum::couples() const {
  std::vector<Eigen::Triplet<double>> couples;
  for (const std::vector<int>& clique : cliques_)
    for (int i : clique)
      for (int j : clique)
        if (i != j) couples.emplace_back(i, j, 1.0);
  Eigen::SparseMatrix<double> pattern(count_, count_);
  pattern.setFromTriplets(couples.begin(), couples.end());
  return pattern;
}

void CliqueSum::analyze() {
  std::vector<Eigen::Triplet<double>> entries;
  const auto addBlock = [&](int row, int column) {
    for (const int r : {0, 1})
      for (const int c : {0, 1}) entries.emplace_back(2 * row + r, 2 * column + c, 0.0);
  };
  const Eigen::SparseMatrix<double> pattern = couples();
  for (int column = 0; column < count_; ++column) {
    addBlock(column, column);
    for (Eigen::SparseMatrix<double>::InnerIterator it(pattern, column); it; ++it)
      addBlock(static_cast<int>(it.row()), column);
  }
  H_.resize(2 * count_, 2 * count_);
  H_.setFromTriplets(entries.begin(), entries.end());

  const int* starts = H_.outerIndexPtr();
  const int* rows = H_.innerIndexPtr();
  for (const std::vector<int>& clique : cliques_)
    for (int i : clique)
      for (int column = 2 * i; column < 2 * i + 2; ++column)
        for (int j : clique) {
          const int* place =
              std::lower_bound(rows + starts[column], rows + starts[column + 1], 2 * j);
          places_.push_back(static_cast<int>(place - rows));
          places_.push_back(static_cast<int>(place - rows) + 1);
        }
  cliques_.clear();
}

void CliqueSum::setZero() {
  std::fill_n(H_.valuePtr(), H_.nonZeros(), 0.0);
  next_ = 0;
}

void CliqueSum::add(const Eigen::MatrixXd& K) {
  double* values = H_.valuePtr();
  for (Eigen::Index i = 0; i < K.size(); ++i) values[places_[next_++]] += K.data()[i];
}

}  // namespace hgp
