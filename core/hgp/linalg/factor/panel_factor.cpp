#include "hgp/linalg/factor/panel_factor.h"

#include <algorithm>
#include <type_traits>

#include "hgp/base/check.h"
#include "hgp/base/parallel.h"
#include "hgp/linalg/factor/deferred_sums.h"
#include "hgp/linalg/factor/panel_solve.h"
#include "hgp/linalg/kernels/kernel_workspace.h"

namespace hgp::linalg {
namespace {

int factorPanel(double* panel, int rows, int pivots, const double* threshold, double* work) {
  return kernels().factorPanelReal(rows, pivots, panel, rows, threshold, work);
}
int factorPanel(std::complex<double>* panel, int rows, int pivots, const double* threshold,
                double* work) {
  return kernels().factorPanelComplex(rows, pivots, raw(panel), rows, threshold, work);
}

// complement := −L21 L21ᴴ
template <class Scalar>
void startComplement(Scalar* panel, int pivots, int rows, Scalar* complement, double* work) {
  double* below = raw(panel + pivots);
  const int ld = pivots + rows;
  const KernelTable::Update task = {rows, rows, pivots, below, below, raw(complement),
                                    ld,   ld,   rows,   true,  true};
  if constexpr (sizeof(Scalar) == sizeof(double))
    kernels().updateReal(task, work);
  else
    kernels().updateComplex(task, work);
}

// The nanoseconds, roughly, of a solve with each node; −1 for nodes of another class.
std::vector<double> solveTimes(const SymbolicFactor& f, int nodeClass, Eigen::Index columns) {
  std::vector<double> times(f.parent.size(), -1.0);
  for (int t = 0; t < f.nodeCount(); ++t)
    if (nodeClass < 0 || f.dynamicNode[t] == nodeClass)
      times[t] =
          static_cast<double>(columns) * (20.0 + 1.0 * f.pivots(t) * (f.pivots(t) + f.rowCount(t)));
  return times;
}

// How many doubles one entry takes.
template <class Scalar>
constexpr std::size_t kDoubles = std::is_same_v<Scalar, double> ? 1 : 2;

template <class Scalar>
Contribution<Scalar> allocate(std::size_t count) {
  return {std::unique_ptr<double[]>(new double[count * kDoubles<Scalar>])};
}

}  // namespace

template <class Scalar>
struct PanelFactor<Scalar>::Scratch {
  explicit Scratch(std::size_t unknowns) : local(unknowns) {}
  KernelWorkspace work;
  std::vector<int> local;
  std::vector<double> threshold;
};

template <class Scalar>
void PanelFactor<Scalar>::layOut(std::shared_ptr<const SymbolicFactor> symbolic, int nodeClass) {
  symbolic_ = std::move(symbolic);
  class_ = nodeClass;
  const int count = symbolic_->nodeCount();
  children_.assign(static_cast<std::size_t>(count), {});
  others_ = children_;
  start_.assign(static_cast<std::size_t>(count) + 1, 0);
  for (int t = 0; t < count; ++t) {
    const std::size_t s = symbolic_->pivots(t), r = symbolic_->rowCount(t);
    start_[t + 1] = start_[t] + (includes(t) ? s * (s + r) : 0);
    const int p = symbolic_->parent[t];
    if (p >= 0 && includes(p)) (includes(t) ? children_ : others_)[p].push_back(t);
  }
  panels_.reset();
  ready_ = false;
}

template <class Scalar>
FactorStatus PanelFactor<Scalar>::eliminate(const FrontSource<Scalar>& source,
                                            const std::vector<double>& diagonal,
                                            std::vector<Contribution<Scalar>>* left) {
  const SymbolicFactor& f = *symbolic_;
  ready_ = false;
  if (!panels_) panels_.reset(new double[start_.back() * kDoubles<Scalar> + 1]);
  std::vector<Contribution<Scalar>> held(static_cast<std::size_t>(f.nodeCount()));
  const ForestWork nodes(f.parent, nodeTimes(f, class_));
  std::vector<std::unique_ptr<Scratch>> scratch(static_cast<std::size_t>(nodes.slots()));
  std::vector<int> badPivot(held.size(), -1);
  const int badNode = nodes.climb([&](int t, int slot) {
    if (!scratch[slot]) scratch[slot] = std::make_unique<Scratch>(f.order.size());
    badPivot[t] = eliminateNode(t, source, diagonal, held, *scratch[slot]);
    return badPivot[t] < 0;
  });
  if (badNode >= 0) {
    panels_.reset();
    return {false, f.nodeStart[badNode] + badPivot[badNode], 0.0};
  }
  if (left != nullptr) *left = std::move(held);
  ready_ = true;
  return {};
}

// Its complement goes to held[t]. Returns the first bad pivot of the node, or −1.
template <class Scalar>
int PanelFactor<Scalar>::eliminateNode(int t, const FrontSource<Scalar>& source,
                                       const std::vector<double>& diagonal,
                                       std::vector<Contribution<Scalar>>& held, Scratch& scratch) {
  const SymbolicFactor& f = *symbolic_;
  KernelWorkspace& work = scratch.work;
  std::vector<int>& local = scratch.local;
  std::vector<double>& threshold = scratch.threshold;
  const int s = f.pivots(t), r = f.rowCount(t), first = f.nodeStart[t];
  Scalar* const P = panel(t);
  threshold.resize(static_cast<std::size_t>(s));
  for (int k = 0; k < s; ++k) {
    local[first + k] = k;
    threshold[k] = kPivotTolerance * diagonal[first + k];
  }
  for (int i = 0; i < r; ++i) local[f.rowsOf(t)[i]] = s + i;
  std::fill(P, P + static_cast<std::size_t>(s) * (s + r), Scalar(0));
  source.addToPanel(t, local.data(), P, s + r);
  const auto addBelow = [&](Scalar* panelTo, Scalar* complementTo) {
    for (const int c : children_[t])
      extendAdd(c, held[c], local.data(), s, panelTo, s + r, complementTo, r);
    if (source.below == nullptr) return;
    for (const int c : others_[t])
      extendAdd(c, (*source.below)[c], local.data(), s, panelTo, s + r, complementTo, r);
  };
  addBelow(P, nullptr);
  const int bad = factorPanel(P, s + r, s, threshold.data(), work.data());
  if (bad >= 0) return bad;
  if (r > 0) {
    held[t] = allocate<Scalar>(static_cast<std::size_t>(r) * r);
    startComplement(P, s, r, held[t].values(), work.data());
    if (source.addToComplement) source.addToComplement(t, local.data(), P, held[t].values());
  }
  addBelow(nullptr, held[t].values());
  for (const int c : children_[t]) held[c] = {};
  return -1;
}

// Adds the part of a child's complement whose columns are pivots here (panelTo) or are not
// (complementTo). Rows ascend on both sides, so lower triangles map into lower triangles.
template <class Scalar>
void PanelFactor<Scalar>::extendAdd(int child, const Contribution<Scalar>& from, const int* local,
                                    int pivots, Scalar* panelTo, int panelRows,
                                    Scalar* complementTo, int rows) {
  const int* childRows = symbolic_->rowsOf(child);
  const int count = symbolic_->rowCount(child);
  const Scalar* values = from.values();
  for (int j = 0; j < count; ++j) {
    const int column = local[childRows[j]];
    const bool isPivot = column < pivots;
    if (isPivot != (panelTo != nullptr)) {
      if (!isPivot) return;  // the rest are beyond the pivots too
      continue;
    }
    Scalar* to = isPivot ? panelTo + static_cast<std::size_t>(column) * panelRows
                         : complementTo + static_cast<std::size_t>(column - pivots) * rows - pivots;
    const Scalar* source = values + static_cast<std::size_t>(j) * count;
    int i = j;
    while (i < count) {  // ranges of consecutive rows, so that the additions vectorise
      const int shift = local[childRows[i]] - i;
      int end = i + 1;
      while (end < count && local[childRows[end]] - end == shift) ++end;
      Scalar* const target = to + shift;
      for (; i < end; ++i) target[i] += source[i];
    }
  }
}

// With the nodes of a subtree in one thread; what it adds beyond is added later, in the order of the nodes.
template <class Scalar>
void PanelFactor<Scalar>::forward(Eigen::Ref<Matrix> x) const {
  struct Term {
    int row;
    Eigen::Index column;
    Scalar value;
  };
  const SymbolicFactor& f = *symbolic_;
  const auto visit = [&](int t, std::vector<Scalar>& w, const auto& add) {
    const int s = f.pivots(t), r = f.rowCount(t);
    const Panel<Scalar> P{panel(t), s + r, s};
    for (Eigen::Index c = 0; c < x.cols(); ++c) {
      Scalar* const top = &x(f.nodeStart[t], c);
      w.assign(top, top + s);
      w.resize(static_cast<std::size_t>(s + r));
      P.forward(w.data());
      std::copy(w.begin(), w.begin() + s, top);
      for (int i = 0; i < r; ++i) add(f.rowsOf(t)[i], c, w[s + i]);
    }
  };
  const ForestWork nodes(f.parent, solveTimes(f, class_, x.cols()));
  if (nodes.slots() == 1) {
    std::vector<Scalar> w;
    for (int t = 0; t < f.nodeCount(); ++t)
      if (includes(t))
        visit(t, w, [&](int row, Eigen::Index c, const Scalar& value) { x(row, c) += value; });
    return;
  }
  DeferredSums<Term> above(nodes);
  nodes.climbItems([&](int item, int) {
    const ForestWork::Item& own = nodes.items()[item];
    const int last = f.nodeStart[own.end];
    above.begin(
        item, [&](const Term& term) { return term.row < last; },
        [&](const Term& term) { x(term.row, term.column) += term.value; });
    std::vector<Scalar> w;
    for (int t = own.begin; t < own.end; ++t)
      if (includes(t))
        visit(t, w, [&, at = item](int row, Eigen::Index c, const Scalar& value) {
          if (row < last)
            x(row, c) += value;
          else
            above.push(at, {row, c, value});
        });
  });
  for (std::size_t i = 0; i < nodes.items().size(); ++i)
    for (const Term& term : above.left(static_cast<int>(i))) x(term.row, term.column) += term.value;
}

template <class Scalar>
void PanelFactor<Scalar>::backward(Eigen::Ref<Matrix> x) const {
  const SymbolicFactor& f = *symbolic_;
  const ForestWork nodes(f.parent, solveTimes(f, class_, x.cols()));
  std::vector<std::vector<Scalar>> scratch(static_cast<std::size_t>(nodes.slots()));
  nodes.descend([&](int t, int slot) {
    const int s = f.pivots(t), r = f.rowCount(t);
    const Panel<Scalar> P{panel(t), s + r, s};
    std::vector<Scalar>& w = scratch[slot];
    for (Eigen::Index c = 0; c < x.cols(); ++c) {
      Scalar* const top = &x(f.nodeStart[t], c);
      w.assign(top, top + s);
      for (int i = 0; i < r; ++i) w.push_back(x(f.rowsOf(t)[i], c));
      P.backward(w.data());
      std::copy(w.begin(), w.begin() + s, top);
    }
  });
}

template class PanelFactor<double>;
template class PanelFactor<std::complex<double>>;

}  // namespace hgp::linalg
