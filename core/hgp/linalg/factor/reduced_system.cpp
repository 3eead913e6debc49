#include "hgp/linalg/factor/reduced_system.h"

#include <algorithm>

#include "hgp/base/check.h"
#include "hgp/linalg/factor/diagonal_lifts.h"

namespace hgp::linalg {
namespace {

/// One block takes the place of several while its square of entries is at most this times theirs: it is passed over
/// once instead of once for each, which pays for half as many zeros.
constexpr double kMergedShare = 1.5;

}  // namespace

void ReducedSystem::build(const SymbolicFactor& full, const ComplexSparse& H,
                          const Cliques& cliques, std::vector<Contribution<Complex>> complements) {
  numberUnknowns(full);
  doubleSymbolic(full);
  takeComplements(full, std::move(complements));
  takeMatrix(full, H);
  takeCliques(full, cliques);
  panels_.layOut(symbolic_);
}

void ReducedSystem::numberUnknowns(const SymbolicFactor& full) {
  position_.clear();
  nodeOf_.clear();
  index_.assign(full.order.size(), -1);
  nodeName_.assign(full.parent.size(), -1);
  int nodes = 0;
  for (int t = 0; t < full.nodeCount(); ++t) {
    if (!full.dynamicNode[t]) continue;
    nodeName_[t] = nodes++;
    for (int k = full.nodeStart[t]; k < full.nodeStart[t + 1]; ++k) {
      index_[k] = count();
      position_.push_back(k);
      nodeOf_.push_back(nodeName_[t]);
    }
  }
}

// The dynamic nodes with every unknown written as a real pair; order and position are identities.
void ReducedSystem::doubleSymbolic(const SymbolicFactor& full) {
  symbolic_ = std::make_shared<SymbolicFactor>();
  SymbolicFactor& f = *symbolic_;
  for (int k = 0; k < 2 * count(); ++k) f.order.push_back(k);
  f.position = f.order;
  f.nodeStart.push_back(0);
  f.rowStart.push_back(0);
  for (int t = 0; t < full.nodeCount(); ++t) {
    if (!full.dynamicNode[t]) continue;
    f.nodeStart.push_back(f.nodeStart.back() + 2 * full.pivots(t));
    f.parent.push_back(full.parent[t] < 0 ? -1 : nodeName_[full.parent[t]]);
    f.dynamicNode.push_back(1);
    for (int i = 0; i < full.rowCount(t); ++i) {
      const int d = index_[full.rowsOf(t)[i]];
      f.rows.push_back(2 * d);
      f.rows.push_back(2 * d + 1);
    }
    f.rowStart.push_back(static_cast<std::int64_t>(f.rows.size()));
  }
}

void ReducedSystem::takeComplements(const SymbolicFactor& full,
                                    std::vector<Contribution<Complex>> complements) {
  blocks_.assign(symbolic_->parent.size(), {});
  for (int t = 0; t < full.nodeCount(); ++t) {
    if (!complements[t].memory) continue;
    const int r = full.rowCount(t), home = nodeName_[full.parent[t]];
    SchurBlock block;
    for (int i = 0; i < r; ++i) block.index.push_back(index_[full.rowsOf(t)[i]]);
    block.values = Eigen::Map<const Eigen::MatrixXcd>(complements[t].values(), r, r);
    complements[t] = {};
    blocks_[home].push_back(std::move(block));
  }
  for (std::vector<SchurBlock>& blocks : blocks_) mergeBlocks(&blocks);
}

// One block over the union of all, when that is not much larger than they are together.
void ReducedSystem::mergeBlocks(std::vector<SchurBlock>* blocks) const {
  if (blocks->size() < 2) return;
  SchurBlock all;
  double separate = 0;
  for (const SchurBlock& p : *blocks) {
    separate += static_cast<double>(p.index.size()) * static_cast<double>(p.index.size());
    all.index.insert(all.index.end(), p.index.begin(), p.index.end());
  }
  std::sort(all.index.begin(), all.index.end());
  all.index.erase(std::unique(all.index.begin(), all.index.end()), all.index.end());
  const int size = static_cast<int>(all.index.size());
  if (static_cast<double>(size) * size > kMergedShare * separate) return;
  all.values.setZero(size, size);
  for (const SchurBlock& p : *blocks) {
    std::vector<int> at;
    for (const int d : p.index)
      at.push_back(static_cast<int>(std::lower_bound(all.index.begin(), all.index.end(), d) -
                                    all.index.begin()));
    for (std::size_t j = 0; j < at.size(); ++j)
      for (std::size_t i = j; i < at.size(); ++i)
        all.values(at[i], at[j]) += p.values(static_cast<int>(i), static_cast<int>(j));
  }
  blocks->clear();
  blocks->push_back(std::move(all));
}

void ReducedSystem::takeMatrix(const SymbolicFactor& full, const ComplexSparse& H) {
  std::vector<Eigen::Triplet<Complex>> triplets;
  std::vector<Coordinate> coordinates;
  matrixValues_.clear();
  matrixDiagonal_.assign(2 * position_.size(), 0.0);
  const auto add = [&](int row, int column, double value) {
    coordinates.push_back({row, column, static_cast<int>(matrixValues_.size())});
    matrixValues_.push_back(value);
  };
  for (int d = 0; d < count(); ++d)
    for (ComplexSparse::InnerIterator it(H, full.order[position_[d]]); it; ++it) {
      const int e = index_[full.position[it.row()]];
      if (e < 0) continue;
      triplets.emplace_back(e, d, it.value());
      if (e < d) continue;
      const double re = it.value().real(), im = it.value().imag();
      add(2 * e, 2 * d, re);
      add(2 * e + 1, 2 * d + 1, re);
      if (e == d) {
        matrixDiagonal_[2 * d] = matrixDiagonal_[2 * d + 1] = std::abs(re);
        continue;
      }
      add(2 * e + 1, 2 * d, im);
      add(2 * e, 2 * d + 1, -im);
    }
  H_.resize(count(), count());
  H_.setFromTriplets(triplets.begin(), triplets.end());
  matrixEntries_ = entryList(coordinates);
}

void ReducedSystem::takeCliques(const SymbolicFactor& full, const Cliques& cliques) {
  offset_.assign(1, 0);
  blockDiagonal_.clear();
  std::vector<Coordinate> coordinates;
  for (const std::vector<int>& clique : cliques) {
    const int size = 2 * static_cast<int>(clique.size());
    const int base = static_cast<int>(offset_.back());
    std::vector<int> at;
    for (const int v : clique) {
      const int d = index_[full.position[v]];
      at.push_back(2 * d);
      at.push_back(2 * d + 1);
    }
    for (int j = 0; j < size; ++j) {
      blockDiagonal_.emplace_back(at[j], base + j * size + j);
      for (int i = 0; i < size; ++i)
        if (at[i] >= at[j]) coordinates.push_back({at[i], at[j], base + j * size + i});
    }
    offset_.push_back(offset_.back() + static_cast<std::size_t>(size) * size);
  }
  HGP_CHECK(offset_.back() < (std::size_t{1} << 31), "blocks hold %zu numbers", offset_.back());
  blockEntries_ = entryList(coordinates);
}

// Bucket sort by node, then panel offsets through the node's own row numbering.
ReducedSystem::EntryList ReducedSystem::entryList(
    const std::vector<Coordinate>& coordinates) const {
  const SymbolicFactor& f = *symbolic_;
  EntryList list;
  list.start.assign(f.parent.size() + 1, 0);
  for (const Coordinate& c : coordinates) ++list.start[nodeOf_[c.column / 2] + 1];
  for (std::size_t t = 1; t < list.start.size(); ++t) list.start[t] += list.start[t - 1];
  std::vector<const Coordinate*> sorted(coordinates.size());
  std::vector<std::size_t> next(list.start.begin(), list.start.end() - 1);
  for (const Coordinate& c : coordinates) sorted[next[nodeOf_[c.column / 2]]++] = &c;
  list.entries.resize(coordinates.size());
  std::vector<int> local(static_cast<std::size_t>(f.size()), -1);
  for (int t = 0; t < f.nodeCount(); ++t) {
    const int first = f.nodeStart[t], s = f.pivots(t), rows = s + f.rowCount(t);
    for (int k = 0; k < s; ++k) local[first + k] = k;
    for (int i = 0; i < f.rowCount(t); ++i) local[f.rowsOf(t)[i]] = s + i;
    for (std::size_t e = list.start[t]; e < list.start[t + 1]; ++e)
      list.entries[e] = {(sorted[e]->column - first) * rows + local[sorted[e]->row],
                         sorted[e]->source};
  }
  return list;
}

Eigen::VectorXcd ReducedSystem::apply(const Eigen::VectorXcd& x) const {
  Eigen::VectorXcd y = H_ * x;
  Eigen::VectorXcd in, out;
  for (const std::vector<SchurBlock>& blocks : blocks_)
    for (const SchurBlock& p : blocks) {
      const int size = static_cast<int>(p.index.size());
      in.resize(size);
      for (int i = 0; i < size; ++i) in[i] = x[p.index[i]];
      out.noalias() = p.values.selfadjointView<Eigen::Lower>() * in;
      for (int i = 0; i < size; ++i) y[p.index[i]] += out[i];
    }
  return y;
}

Eigen::MatrixXcd ReducedSystem::dense() const {
  Eigen::MatrixXcd out = H_;
  for (const std::vector<SchurBlock>& blocks : blocks_)
    for (const SchurBlock& p : blocks) {
      const int size = static_cast<int>(p.index.size());
      for (int j = 0; j < size; ++j)
        for (int i = j; i < size; ++i) {
          out(p.index[i], p.index[j]) += p.values(i, j);
          if (i != j) out(p.index[j], p.index[i]) += std::conj(p.values(i, j));
        }
    }
  return out;
}

void ReducedSystem::fillPanel(int t, const int* local, double* panel, int rows,
                              const double* values, double lift) const {
  for (std::size_t e = matrixEntries_.start[t]; e < matrixEntries_.start[t + 1]; ++e)
    panel[matrixEntries_.entries[e].target] += matrixValues_[matrixEntries_.entries[e].source];
  for (std::size_t e = blockEntries_.start[t]; e < blockEntries_.start[t + 1]; ++e)
    panel[blockEntries_.entries[e].target] += values[blockEntries_.entries[e].source];
  if (lift > 0)
    for (int k = 0; k < symbolic_->pivots(t); ++k)
      panel[static_cast<std::size_t>(k) * rows + k] +=
          lift * diagonal_[symbolic_->nodeStart[t] + k];
  addPieces(t, local, panel, nullptr);
}

// Columns of the blocks that are pivots of t go to the panel, or the others to the complement.
void ReducedSystem::addPieces(int t, const int* local, double* panel, double* complement) const {
  const int s = symbolic_->pivots(t), r = symbolic_->rowCount(t);
  for (const SchurBlock& p : blocks_[t]) {
    const int size = static_cast<int>(p.index.size());
    for (int j = 0; j < size; ++j) {
      const int column = local[2 * p.index[j]];
      if ((column < s) != (complement == nullptr)) continue;
      const int rows = complement == nullptr ? s + r : r;
      double* even = complement == nullptr
                         ? panel + static_cast<std::size_t>(column) * rows
                         : complement + static_cast<std::size_t>(column - s) * rows - s;
      double* odd = even + rows;
      for (int i = j; i < size; ++i) {
        const int row = local[2 * p.index[i]];
        const Complex h = p.values(i, j);
        even[row] += h.real();
        even[row + 1] += h.imag();
        odd[row] -= h.imag();  // for i = j this lies above the diagonal, where nothing is read
        odd[row + 1] += h.real();
      }
    }
  }
}

FactorStatus ReducedSystem::factor(const double* values) {
  diagonal_ = matrixDiagonal_;
  for (const auto& [position, source] : blockDiagonal_) diagonal_[position] += values[source];
  return withLifts([&](double lift) {
    FrontSource<double> source;
    source.addToPanel = [&](int t, const int* local, double* panel, int rows) {
      fillPanel(t, local, panel, rows, values, lift);
    };
    source.addToComplement = [&](int t, const int* local, double* panel, double* complement) {
      addPieces(t, local, panel, complement);
    };
    FactorStatus status = panels_.eliminate(source, diagonal_, nullptr);
    if (!status) status.badPivot /= 2;
    return status;
  });
}

// A Ref is a view: taken by value so that blocks of a matrix can be passed.
// NOLINTNEXTLINE(performance-unnecessary-value-param)
void ReducedSystem::solveInPlace(Eigen::Ref<Eigen::MatrixXd> x) const {
  panels_.forward(x);
  panels_.backward(x);
}

}  // namespace hgp::linalg
