#include <algorithm>
#include <vector>

#include "hgp/base/check.h"
#include "hgp/base/parallel.h"
#include "hgp/base/portable_math.h"
#include "hgp/linalg/factor/schur_lu_state.h"
#include "hgp/linalg/factor/times_adjoint.h"

namespace hgp::linalg {
namespace {

using Complex = std::complex<double>;

// Kept unknowns last, the others as the tree says.
SymbolicFactor analyzeKeptLast(const Graph& pattern, const std::vector<int>& kept,
                               const SeparatorTree& tree) {
  SymbolicOptions options;
  options.dynamic.assign(static_cast<std::size_t>(pattern.size()), 0);
  for (const int v : kept) options.dynamic[v] = 1;
  std::vector<int> order;
  order.reserve(tree.order.size());
  for (const int v : tree.order)
    if (!options.dynamic[v]) order.push_back(v);
  order.insert(order.end(), kept.begin(), kept.end());
  return analyze(pattern, order, options);
}

}  // namespace

namespace {

// Adds a column of A, or a row of it conjugated, to a column of the panel; returns |A_jj|.
template <class Matrix>
double addColumn(const Matrix& A, int unknown, int position, const SymbolicFactor& f,
                 const std::vector<int>& local, Complex* column) {
  double diagonal = 0.0;
  for (typename Matrix::InnerIterator it(A, unknown); it; ++it) {
    const int p = f.position[it.index()];
    if (p == position) diagonal = portable::abs(it.value());
    if (p >= position) column[local[p]] += Matrix::IsRowMajor ? std::conj(it.value()) : it.value();
  }
  return diagonal;
}

// Adds a child's complement to the front: its pivot columns to L, its pivot rows (conjugated) to U, the
// rest to the complement. Rows ascend, so the first `inner` of them are the pivots.
void extendAdd(const int* childRows, int count, const Complex* values,
               const std::vector<int>& local, bool toPanels, Front* front) {
  const int s = front->s, rows = s + front->r;
  int inner = 0;
  while (inner < count && local[childRows[inner]] < s) ++inner;
  if (toPanels) {
    for (int j = 0; j < inner; ++j) {
      const int column = local[childRows[j]];
      Complex* L = front->L.data() + static_cast<std::size_t>(column) * rows;
      Complex* U = front->U + static_cast<std::size_t>(column) * rows;
      for (int i = j; i < count; ++i) {
        const int row = local[childRows[i]];
        L[row] += values[static_cast<std::size_t>(j) * count + i];
        U[row] += std::conj(values[static_cast<std::size_t>(i) * count + j]);
      }
    }
    return;
  }
  Complex* const C = reinterpret_cast<Complex*>(front->complement.get());
  for (int j = inner; j < count; ++j) {
    Complex* column = C + static_cast<std::size_t>(local[childRows[j]] - s) * front->r - s;
    const Complex* source = values + static_cast<std::size_t>(j) * count;
    for (int i = inner; i < count; ++i) column[local[childRows[i]]] += source[i];
  }
}

}  // namespace

void SchurLu::State::layOut() {
  panelStart.assign(1, 0);
  keptAt.assign(symbolic.order.size(), -1);
  for (std::size_t i = 0; i < kept.size(); ++i)
    keptAt[symbolic.position[kept[i]]] = static_cast<int>(i);
  for (int t = 0; t < symbolic.nodeCount(); ++t) {
    const std::size_t s = symbolic.pivots(t), r = symbolic.rowCount(t);
    panelStart.push_back(panelStart.back() + (symbolic.dynamicNode[t] ? 0 : s * (s + r)));
  }
  panels = allocateComplex(panelStart.back() + 1);
  schur.setZero(static_cast<int>(kept.size()), static_cast<int>(kept.size()));
}

void SchurLu::State::addToSchur(int t, const Complex* complement) {
  const int r = symbolic.rowCount(t);
  const int* rows = symbolic.rowsOf(t);
  for (int j = 0; j < r; ++j)
    for (int i = 0; i < r; ++i)
      schur(keptAt[rows[i]], keptAt[rows[j]]) += complement[static_cast<std::size_t>(j) * r + i];
}

// Copies the pivot columns of A and of Aᴴ to the front's zeroed panels.
void SchurLu::State::fillPanels(int t, const SparseRows& A, const SparseColumns& columns,
                                const std::vector<int>& local, Front* front,
                                std::vector<double>* threshold) const {
  const int s = front->s, rows = s + front->r, first = symbolic.nodeStart[t];
  const std::size_t entries = static_cast<std::size_t>(s) * rows;
  front->L.assign(entries, Complex(0));
  std::fill(front->U, front->U + entries, Complex(0));
  threshold->resize(static_cast<std::size_t>(s));
  for (int k = 0; k < s; ++k) {
    const int v = symbolic.order[first + k];
    const std::size_t column = static_cast<std::size_t>(k) * rows;
    addColumn(columns, v, first + k, symbolic, local, front->L.data() + column);
    (*threshold)[k] =
        kPivotTolerance * addColumn(A, v, first + k, symbolic, local, front->U + column);
  }
}

/// Its complement goes to held[t]. Returns the first bad pivot of the node, or −1.
int SchurLu::State::eliminateNode(int t, const SparseRows& A, const SparseColumns& columns,
                                  const std::vector<int>& children, FrontScratch& scratch) {
  const SymbolicFactor& f = symbolic;
  auto& [work, local, threshold] = scratch;
  const int s = f.pivots(t), r = f.rowCount(t), rows = s + r, first = f.nodeStart[t];
  Front front{s, r, {}, panel(t), nullptr};
  for (int k = 0; k < s; ++k) local[first + k] = k;
  for (int i = 0; i < r; ++i) local[f.rowsOf(t)[i]] = s + i;
  fillPanels(t, A, columns, local, &front, &threshold);
  for (const int c : children)
    extendAdd(f.rowsOf(c), f.rowCount(c), complement(c), local, true, &front);
  const int bad = kernels().factorPanelLu(rows, s, raw(front.L.data()), raw(front.U), rows,
                                          threshold.data(), work.data());
  if (bad >= 0 || r == 0) return bad;
  front.complement = allocateComplex(static_cast<std::size_t>(r) * r);
  kernels().updateComplex({r, r, s, raw(front.L.data() + s), raw(front.U + s),
                           front.complement.get(), rows, rows, r, false, true},
                          work.data());
  for (const int c : children) {
    extendAdd(f.rowsOf(c), f.rowCount(c), complement(c), local, false, &front);
    held[c].reset();
  }
  held[t] = std::move(front.complement);
  return -1;
}

FactorStatus SchurLu::State::eliminate(const SparseRows& A, const SparseColumns& columns) {
  const SymbolicFactor& f = symbolic;
  held.resize(static_cast<std::size_t>(f.nodeCount()));
  std::vector<std::vector<int>> children(held.size());
  std::vector<int> belowKept;
  for (int t = 0; t < f.nodeCount(); ++t) {
    if (f.dynamicNode[t] || f.parent[t] < 0) continue;
    (f.dynamicNode[f.parent[t]] ? belowKept : children[f.parent[t]]).push_back(t);
  }
  InOrder toSchur(std::move(belowKept), f.nodeCount(), [&](int t) {
    addToSchur(t, complement(t));
    held[t].reset();
  });
  const ForestWork nodes(f.parent, nodeTimes(f, 0));
  std::vector<std::unique_ptr<FrontScratch>> scratch(static_cast<std::size_t>(nodes.slots()));
  std::vector<int> badPivot(held.size(), -1);
  const int badNode = nodes.climb([&](int t, int slot) {
    if (!scratch[slot]) scratch[slot] = std::make_unique<FrontScratch>(f.order.size());
    badPivot[t] = eliminateNode(t, A, columns, children[t], *scratch[slot]);
    if (badPivot[t] >= 0) return false;
    if (f.parent[t] >= 0 && f.dynamicNode[f.parent[t]]) toSchur.finish(t);
    return true;
  });
  held = std::vector<std::unique_ptr<double[]>>();
  if (badNode >= 0) return {false, f.order[f.nodeStart[badNode] + badPivot[badNode]], 0.0};
  return {};
}

SchurLu::SchurLu() : state_(std::make_unique<State>()) {}
SchurLu::~SchurLu() = default;
SchurLu::SchurLu(SchurLu&&) noexcept = default;
SchurLu& SchurLu::operator=(SchurLu&&) noexcept = default;

FactorStatus SchurLu::build(const SparseRows& A, const std::vector<int>& kept,
                            const SeparatorTree& tree) {
  HGP_CHECK(A.rows() == A.cols() && static_cast<std::size_t>(A.rows()) == tree.order.size(),
            "matrix %d × %d, tree of %d", static_cast<int>(A.rows()), static_cast<int>(A.cols()),
            static_cast<int>(tree.order.size()));
  state_ = std::make_unique<State>();
  state_->kept = kept;
  const SparseColumns columns = A;
  state_->symbolic = analyzeKeptLast(graphOf(columns), kept, tree);
  state_->layOut();
  const FactorStatus status = state_->eliminate(A, columns);
  if (!status) {
    state_ = std::make_unique<State>();
    return status;
  }
  for (const int v : kept)
    for (SparseColumns::InnerIterator it(columns, v); it; ++it) {
      const int row = state_->keptAt[state_->symbolic.position[it.row()]];
      const int column = state_->keptAt[state_->symbolic.position[v]];
      if (row >= 0) state_->schur(row, column) += it.value();
    }
  return status;
}

FactorCost SchurLu::estimate(const Graph& pattern, const std::vector<int>& kept,
                             const SeparatorTree& tree) {
  FactorCost cost = factorCost(analyzeKeptLast(pattern, kept, tree), 0);
  cost.multiplyAdds *= 2.0;
  return cost;
}

FactorCost SchurLu::cost() const {
  FactorCost cost = factorCost(state_->symbolic, 0);
  cost.multiplyAdds *= 2.0;
  return cost;
}

const Eigen::MatrixXcd& SchurLu::schur() const { return state_->schur; }

Eigen::MatrixXcd SchurLu::gram(const Eigen::VectorXd& weight) const {
  return timesAdjoint(Eigen::MatrixXcd((weight.asDiagonal() * state_->schur).adjoint()));
}

}  // namespace hgp::linalg
