#include "hgp/optimize/real_form.h"

#include <algorithm>

namespace hgp {
namespace {

/// The unknown of a column of a constraint's F.
int unknownOf(const socp::ConeConstraint& constraint, Eigen::Index column) {
  return 2 * constraint.unknowns[at(column / 2)] + static_cast<int>(column % 2);
}

bool isUsed(const socp::ConeConstraint& constraint, Eigen::Index column) {
  return !constraint.F.col(column).isZero(0.0);
}

linalg::Cliques cliquesOf(const std::vector<socp::ConeConstraint>& constraints) {
  linalg::Cliques cliques(constraints.size());
  for (std::size_t b = 0; b < constraints.size(); ++b)
    for (Eigen::Index c = 0; c < constraints[b].F.cols(); ++c)
      if (isUsed(constraints[b], c)) cliques[b].push_back(unknownOf(constraints[b], c));
  return cliques;
}

/// Calls use(row, column of the block) for the entries of a block that may be other than 0.
template <class Use>
void forEachEntry(const socp::ConeConstraint& constraint, const Use& use) {
  for (Eigen::Index c = 0; c < constraint.F.cols(); ++c)
    for (Eigen::Index r = 0; r < constraint.F.cols(); ++r)
      if (isUsed(constraint, c) && isUsed(constraint, r)) use(r, c);
}

}  // namespace

RealForm::RealForm(const Eigen::SparseMatrix<double>& H, const linalg::SeparatorTree& tree,
                   const std::vector<socp::ConeConstraint>& constraints)
    : blocks_(H.rows(), H.cols()) {
  layOut(constraints);
  factor_.build(H, tree, cliquesOf(constraints));
}

/// blocks_ gets the pattern of all blocks together; terms_ say where their numbers go.
void RealForm::layOut(const std::vector<socp::ConeConstraint>& constraints) {
  std::vector<Eigen::Triplet<double>> pattern;
  for (const socp::ConeConstraint& constraint : constraints)
    forEachEntry(constraint, [&](Eigen::Index r, Eigen::Index c) {
      pattern.emplace_back(unknownOf(constraint, r), unknownOf(constraint, c), 0.0);
    });
  blocks_.setFromTriplets(pattern.begin(), pattern.end());
  const auto place = [&](int row, int column) {
    const int* begin = blocks_.innerIndexPtr() + blocks_.outerIndexPtr()[column];
    const int* end = blocks_.innerIndexPtr() + blocks_.outerIndexPtr()[column + 1];
    return at(std::lower_bound(begin, end, row) - blocks_.innerIndexPtr());
  };
  terms_.reserve(pattern.size());
  for (const socp::ConeConstraint& constraint : constraints) {
    const Eigen::Index size = constraint.F.cols();
    forEachEntry(constraint, [&](Eigen::Index r, Eigen::Index c) {
      terms_.push_back({place(unknownOf(constraint, r), unknownOf(constraint, c)),
                        offset_.back() + at(c * size + r)});
    });
    offset_.push_back(offset_.back() + at(size * size));
  }
}

double RealForm::multiplyAdds(int factorizations) const {
  return factor_.staticCost().multiplyAdds + factorizations * factor_.reducedCost().multiplyAdds;
}

linalg::FactorStatus RealForm::factor(const double* values) {
  std::fill(blocks_.valuePtr(), blocks_.valuePtr() + blocks_.nonZeros(), 0.0);
  for (const Term& term : terms_) blocks_.valuePtr()[term.target] += values[term.source];
  return factor_.factor(blocks_);
}

}  // namespace hgp
