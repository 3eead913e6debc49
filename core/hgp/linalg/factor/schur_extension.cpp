#include "hgp/linalg/factor/schur_extension.h"

#include <algorithm>
#include <numeric>

#include "hgp/base/check.h"
#include "hgp/base/parallel.h"
#include "hgp/linalg/factor/panel_solve.h"
#include "hgp/linalg/factor/schur_lu_state.h"

namespace hgp::linalg {

SchurExtension::SchurExtension(const SchurLu& lu, const Eigen::MatrixXcd& xKept)
    : lu_(*lu.state_),
      columns_(xKept.cols()),
      row_(static_cast<std::size_t>(lu_.symbolic.size()), nullptr) {
  HGP_CHECK(xKept.rows() == static_cast<int>(lu_.kept.size()), "%d rows for %d kept unknowns",
            static_cast<int>(xKept.rows()), static_cast<int>(lu_.kept.size()));
  Rows& kept = blocks_.emplace_back(xKept);
  for (std::size_t k = 0; k < row_.size(); ++k)
    if (lu_.keptAt[k] >= 0) row_[k] = kept.row(lu_.keptAt[k]).data();
}

/// Nodes that hold one of the unknowns, and all their ancestors, without those that were visited.
std::vector<char> SchurExtension::newNodes(const std::vector<int>& unknowns) const {
  const SymbolicFactor& f = lu_.symbolic;
  std::vector<char> isNew(static_cast<std::size_t>(f.nodeCount()), 0);
  std::vector<char> isMissing(row_.size(), 0);
  for (const int unknown : unknowns) {
    const int k = f.position[unknown];
    isMissing[k] = row_[k] == nullptr;
  }
  for (int t = 0; t < f.nodeCount(); ++t) {
    const int first = f.nodeStart[t];
    for (int k = first; k < f.nodeStart[t + 1]; ++k) isNew[t] |= isMissing[k];
    if (isNew[t] && f.parent[t] >= 0) isNew[f.parent[t]] = 1;
    if (f.pivots(t) > 0 && row_[first] != nullptr) isNew[t] = 0;
  }
  return isNew;
}

void SchurExtension::addRows(const std::vector<char>& isNew) {
  const SymbolicFactor& f = lu_.symbolic;
  int count = 0;
  for (int t = 0; t < f.nodeCount(); ++t)
    if (isNew[t]) count += f.pivots(t);
  if (count == 0) return;
  Complex* next = blocks_.emplace_back(count, columns_).data();
  for (int t = 0; t < f.nodeCount(); ++t) {
    if (!isNew[t]) continue;
    for (int k = f.nodeStart[t]; k < f.nodeStart[t + 1]; ++k, next += columns_) row_[k] = next;
  }
}

/// x at the pivots of t from x at its rows.
void SchurExtension::backward(int t) {
  const SymbolicFactor& f = lu_.symbolic;
  const int s = f.pivots(t), r = f.rowCount(t);
  const Panel<Complex> U{lu_.panel(t), s + r, s};
  Complex* const* pivots = row_.data() + f.nodeStart[t];
  const auto above = [&](int i) { return row_[f.rowsOf(t)[i]]; };
  std::vector<FourComplex> four(static_cast<std::size_t>(s) + r, FourComplex{});
  Eigen::Index done = 0;
  for (; done + 4 <= columns_; done += 4) {
    std::fill(four.begin(), four.begin() + s, FourComplex{});
    for (int i = 0; i < r; ++i)
      for (int c = 0; c < 4; ++c) four[static_cast<std::size_t>(s) + i].set(c, above(i)[done + c]);
    U.backward(four.data());
    for (int i = 0; i < s; ++i)
      for (int c = 0; c < 4; ++c)
        pivots[i][done + c] = {four[static_cast<std::size_t>(i)].re[c],
                               four[static_cast<std::size_t>(i)].im[c]};
  }
  std::vector<Complex> w;
  for (Eigen::Index c = done; c < columns_; ++c) {
    w.assign(static_cast<std::size_t>(s), 0.0);
    for (int i = 0; i < r; ++i) w.push_back(above(i)[c]);
    U.backward(w.data());
    for (int i = 0; i < s; ++i) pivots[i][c] = w[static_cast<std::size_t>(i)];
  }
}

Eigen::MatrixXcd SchurExtension::rows(const std::vector<int>& unknowns) {
  const SymbolicFactor& f = lu_.symbolic;
  const std::vector<char> isNew = newNodes(unknowns);
  addRows(isNew);
  std::vector<double> times(isNew.size(), -1.0);
  for (int t = 0; t < f.nodeCount(); ++t) {
    const double entries = 1.0 * f.pivots(t) * (f.pivots(t) + f.rowCount(t));
    if (isNew[t]) times[t] = static_cast<double>(columns_) * (20.0 + 2.0 * entries);
  }
  ForestWork(f.parent, times).descend([&](int t, int) { backward(t); });
  Eigen::MatrixXcd result(static_cast<Eigen::Index>(unknowns.size()), columns_);
  for (std::size_t i = 0; i < unknowns.size(); ++i)
    result.row(static_cast<Eigen::Index>(i)) =
        Eigen::Map<const Eigen::RowVectorXcd>(row_[f.position[unknowns[i]]], columns_);
  return result;
}

Eigen::MatrixXcd SchurLu::extend(const Eigen::MatrixXcd& xKept) const {
  std::vector<int> all(static_cast<std::size_t>(state_->symbolic.size()));
  std::iota(all.begin(), all.end(), 0);
  return SchurExtension(*this, xKept).rows(all);
}

}  // namespace hgp::linalg
