#include "hgp/optimize/real_form.h"

#include <algorithm>

namespace hgp {
namespace {

/// Relative lifts of the diagonal that are tried in turn where a pivot is not positive.
constexpr double kLifts[] = {0.0, 1e-13, 1e-11, 1e-9};

}  // namespace

RealForm::RealForm(const Eigen::SparseMatrix<double>& H, const linalg::SeparatorTree& tree,
                   std::vector<std::vector<int>> pairs, const std::vector<std::vector<char>>& used)
    : H_(H) {
  layOut(std::move(pairs), used);
  factor_.analyze(linalg::graphOf(K_), tree);
}

/// K_ gets the pattern of H_ and of all blocks; terms_ say where their numbers go.
void RealForm::layOut(std::vector<std::vector<int>> pairs,
                      const std::vector<std::vector<char>>& used) {
  struct Entry {
    int row, column;
    std::size_t source;
  };
  std::vector<Entry> entries;
  std::vector<Eigen::Triplet<double>> pattern;
  pattern.reserve(static_cast<std::size_t>(H_.nonZeros()));
  for (Eigen::Index j = 0; j < H_.cols(); ++j) {
    // The diagonal is lifted where a factor needs that, also of an unknown that is in no row of H.
    pattern.emplace_back(static_cast<int>(j), static_cast<int>(j), 0.0);
    for (Eigen::SparseMatrix<double>::InnerIterator it(H_, j); it; ++it)
      pattern.emplace_back(static_cast<int>(it.row()), static_cast<int>(j), 0.0);
  }
  for (std::size_t b = 0; b < pairs.size(); ++b) {
    const std::size_t size = 2 * pairs[b].size();
    const auto unknown = [&](std::size_t c) {
      return 2 * pairs[b][c / 2] + static_cast<int>(c % 2);
    };
    for (std::size_t c = 0; c < size; ++c)
      for (std::size_t r = 0; r < size; ++r) {
        if (!used[b][c] || !used[b][r]) continue;
        entries.push_back({unknown(r), unknown(c), offset_.back() + c * size + r});
        pattern.emplace_back(unknown(r), unknown(c), 0.0);
      }
    offset_.push_back(offset_.back() + size * size);
  }
  K_ = Eigen::SparseMatrix<double>(H_.rows(), H_.cols());
  K_.setFromTriplets(pattern.begin(), pattern.end());
  K_.makeCompressed();
  for (const Entry& e : entries) {
    const int* begin = K_.innerIndexPtr() + K_.outerIndexPtr()[e.column];
    const int* end = K_.innerIndexPtr() + K_.outerIndexPtr()[e.column + 1];
    const int* found = std::lower_bound(begin, end, e.row);
    terms_.push_back({static_cast<std::size_t>(found - K_.innerIndexPtr()), e.source});
  }
}

Eigen::VectorXd RealForm::apply(const Eigen::VectorXd& x) const {
  Eigen::VectorXd out = Eigen::VectorXd::Zero(x.size());
  out.head(H_.rows()) = H_ * x.head(H_.rows());
  return out;
}

linalg::FactorStatus RealForm::factor(const double* values) {
  double* numbers = K_.valuePtr();
  std::fill(numbers, numbers + K_.nonZeros(), 0.0);
  for (Eigen::Index j = 0; j < H_.cols(); ++j) {
    // The pattern of H is a part of that of K; both ascend.
    Eigen::SparseMatrix<double>::InnerIterator it(K_, j);
    for (Eigen::SparseMatrix<double>::InnerIterator own(H_, j); own; ++own) {
      while (it.row() != own.row()) ++it;
      it.valueRef() = own.value();
    }
  }
  for (const Term& term : terms_) numbers[term.target] += values[term.source];
  const Eigen::VectorXd diagonal = K_.diagonal();
  linalg::FactorStatus status;
  for (const double lift : kLifts) {
    if (lift > 0.0) K_.diagonal() = (1.0 + lift) * diagonal;
    status = factor_.factor(K_);
    status.lift = lift;
    if (status) break;
  }
  return status;
}

Eigen::VectorXd RealForm::solve(const Eigen::VectorXd& rhs) const {
  Eigen::VectorXd out = Eigen::VectorXd::Zero(rhs.size());
  out.head(H_.rows()) = factor_.solve(Eigen::MatrixXd(rhs.head(H_.rows()))).col(0);
  return out;
}

}  // namespace hgp
