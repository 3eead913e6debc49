#include "hgp/linalg/factor/panel_factor.h"

#include <algorithm>
#include <type_traits>

#include "hgp/base/check.h"
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

// How many doubles one entry takes.
template <class Scalar>
constexpr std::size_t kDoubles = std::is_same_v<Scalar, double> ? 1 : 2;

template <class Scalar>
Contribution<Scalar> allocate(std::size_t count) {
  return {std::unique_ptr<double[]>(new double[count * kDoubles<Scalar>])};
}

}  // namespace

template <class Scalar>
void PanelFactor<Scalar>::layOut(std::shared_ptr<const SymbolicFactor> symbolic, int nodeClass) {
  symbolic_ = std::move(symbolic);
  class_ = nodeClass;
  const int count = symbolic_->nodeCount();
  children_.assign(static_cast<std::size_t>(count), {});
  start_.assign(static_cast<std::size_t>(count) + 1, 0);
  for (int t = 0; t < count; ++t) {
    const std::size_t s = symbolic_->pivots(t), r = symbolic_->rowCount(t);
    start_[t + 1] = start_[t] + (includes(t) ? s * (s + r) : 0);
    const int p = symbolic_->parent[t];
    if (p >= 0 && includes(t) && includes(p)) children_[p].push_back(t);
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
  const KernelWorkspace work;
  std::vector<Contribution<Scalar>> held(static_cast<std::size_t>(f.nodeCount()));
  std::vector<int> local(static_cast<std::size_t>(f.size()));
  std::vector<double> threshold;
  for (int t = 0; t < f.nodeCount(); ++t) {
    if (!includes(t)) continue;
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
    for (const int c : children_[t]) extendAdd(c, held[c], local.data(), s, P, s + r, nullptr, r);
    const int bad = factorPanel(P, s + r, s, threshold.data(), work.data());
    if (bad >= 0) {
      panels_.reset();
      return {false, first + bad, 0.0};
    }
    if (r > 0) {
      held[t] = allocate<Scalar>(static_cast<std::size_t>(r) * r);
      startComplement(P, s, r, held[t].values(), work.data());
      if (source.addToComplement) source.addToComplement(t, local.data(), P, held[t].values());
    }
    for (const int c : children_[t]) {
      extendAdd(c, held[c], local.data(), s, nullptr, s + r, held[t].values(), r);
      held[c] = {};
    }
  }
  if (left != nullptr) *left = std::move(held);
  ready_ = true;
  return {};
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

template <class Scalar>
void PanelFactor<Scalar>::forward(Eigen::Ref<Matrix> x) const {
  const SymbolicFactor& f = *symbolic_;
  std::vector<Scalar> w;
  for (int t = 0; t < f.nodeCount(); ++t) {
    if (!includes(t)) continue;
    const int s = f.pivots(t), r = f.rowCount(t);
    const Panel<Scalar> P{panel(t), s + r, s};
    for (Eigen::Index c = 0; c < x.cols(); ++c) {
      Scalar* const top = &x(f.nodeStart[t], c);
      w.assign(top, top + s);
      w.resize(static_cast<std::size_t>(s + r));
      P.forward(w.data());
      std::copy(w.begin(), w.begin() + s, top);
      for (int i = 0; i < r; ++i) x(f.rowsOf(t)[i], c) += w[s + i];
    }
  }
}

template <class Scalar>
void PanelFactor<Scalar>::backward(Eigen::Ref<Matrix> x) const {
  const SymbolicFactor& f = *symbolic_;
  std::vector<Scalar> w;
  for (int t = f.nodeCount() - 1; t >= 0; --t) {
    if (!includes(t)) continue;
    const int s = f.pivots(t), r = f.rowCount(t);
    const Panel<Scalar> P{panel(t), s + r, s};
    for (Eigen::Index c = 0; c < x.cols(); ++c) {
      Scalar* const top = &x(f.nodeStart[t], c);
      w.assign(top, top + s);
      for (int i = 0; i < r; ++i) w.push_back(x(f.rowsOf(t)[i], c));
      P.backward(w.data());
      std::copy(w.begin(), w.begin() + s, top);
    }
  }
}

template class PanelFactor<double>;
template class PanelFactor<std::complex<double>>;

}  // namespace hgp::linalg
