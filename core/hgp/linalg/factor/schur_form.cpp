#include <algorithm>

#include "hgp/base/parallel.h"
#include "hgp/base/portable_math.h"
#include "hgp/linalg/factor/deferred_sums.h"
#include "hgp/linalg/factor/panel_solve.h"
#include "hgp/linalg/factor/schur_lu_state.h"

namespace hgp::linalg {
namespace {

using Complex = std::complex<double>;

/// Columns that are solved for by loops before the rest is updated by one product.
constexpr int kBlock = 24;

/// One front of the form: pivot columns, (s + r) × s, and the r × r complement; lower triangles.
struct FormFront {
  int s, r;
  std::vector<Complex> panel;
  std::unique_ptr<double[]> complement;

  Complex* below() { return reinterpret_cast<Complex*>(complement.get()); }
  void add(int row, int column, const Complex& value) {
    if (column < s)
      panel[static_cast<std::size_t>(column) * (s + r) + row] += value;
    else
      below()[static_cast<std::size_t>(column - s) * r + (row - s)] += value;
  }
};

/// What one thread needs for fronts, and where the terms of c go that are beyond its subtree.
struct FormScratch {
  explicit FormScratch(std::size_t unknowns) : local(unknowns) {}
  std::vector<int> local;
  std::vector<Complex> n, y, half, transposed;
  FormElements::Element element;
  KernelWorkspace work;
};

/// c[position] += value.
struct LinearTerm {
  int position;
  Complex value;
};

class FormRestriction {
 public:
  FormRestriction(const SchurLu::State& lu, const FormElements& elements)
      : lu_(lu), f_(lu.symbolic), elements_(elements), c_(f_.size()) {
    c_.setZero();
    result_.H.setZero(static_cast<Eigen::Index>(lu.kept.size()),
                      static_cast<Eigen::Index>(lu.kept.size()));
  }

  QuadraticForm run() {
    groupElements();
    held_.resize(static_cast<std::size_t>(f_.nodeCount()));
    children_.resize(held_.size());
    for (int t = 0; t < f_.nodeCount(); ++t)
      if (!f_.dynamicNode[t] && f_.parent[t] >= 0) children_[f_.parent[t]].push_back(t);
    const ForestWork nodes(f_.parent, nodeTimes(f_, 0));
    if (nodes.slots() == 1)
      visitAll();
    else
      visitShared(nodes);
    result_.H = Eigen::MatrixXcd(result_.H.selfadjointView<Eigen::Lower>());
    result_.c.resize(result_.H.rows());
    for (int k = 0; k < f_.size(); ++k)
      if (lu_.keptAt[k] >= 0) result_.c[lu_.keptAt[k]] = c_[k];
    return std::move(result_);
  }

 private:
  auto addToC() {
    return [this](int position, const Complex& value) { c_[position] += value; };
  }

  void visitAll() {
    FormScratch scratch(f_.order.size());
    for (int t = 0; t < f_.nodeCount(); ++t) {
      if (!f_.dynamicNode[t]) visit(t, scratch, addToC());
      takeResult(t, scratch);
    }
  }

  /// Subtrees in several threads, with all sums in the order of visitAll.
  void visitShared(const ForestWork& nodes) {
    std::vector<std::unique_ptr<FormScratch>> scratch(static_cast<std::size_t>(nodes.slots()));
    DeferredSums<LinearTerm> above(nodes);
    nodes.climbItems([&](int item, int slot) {
      const ForestWork::Item& own = nodes.items()[item];
      const int last = f_.nodeStart[own.end];
      if (!scratch[slot]) scratch[slot] = std::make_unique<FormScratch>(f_.order.size());
      above.begin(
          item, [&](const LinearTerm& term) { return term.position < last; },
          [&](const LinearTerm& term) { c_[term.position] += term.value; });
      for (int t = own.begin; t < own.end; ++t)
        if (nodes.isVisited(t))
          visit(t, *scratch[slot], [&](int position, const Complex& value) {
            if (value == Complex(0.0)) return;  // most are, and to add them changes nothing
            if (position < last)
              c_[position] += value;
            else
              above.push(item, {position, value});
          });
    });
    FormScratch rest(f_.order.size());
    std::size_t item = 0;
    for (int t = 0; t < f_.nodeCount(); ++t) {
      if (item < nodes.items().size() && nodes.items()[item].end == t + 1)
        for (const LinearTerm& term : above.left(static_cast<int>(item++)))
          c_[term.position] += term.value;
      takeResult(t, rest);
    }
  }

  /// Eliminates a node; its complement goes to held_[t].
  template <class AddToC>
  void visit(int t, FormScratch& scratch, const AddToC& addToC) {
    FormFront front = assemble(t, scratch, addToC);
    for (const int child : children_[t]) {
      addChild(child, reinterpret_cast<const Complex*>(held_[child].get()), scratch.local, front);
      held_[child].reset();
    }
    if (front.r == 0) return;
    eliminate(t, front, scratch, addToC);
    held_[t] = std::move(front.complement);
  }

  /// Adds what a node leaves to kept unknowns.
  void takeResult(int t, FormScratch& scratch) {
    if (f_.dynamicNode[t]) {
      addToRoot(t, scratch.element);
    } else if (held_[t] && f_.dynamicNode[f_.parent[t]]) {
      addToResult(t, reinterpret_cast<const Complex*>(held_[t].get()));
      held_[t].reset();
    }
  }

  /// Elements by the node of their first unknown.
  void groupElements() {
    std::vector<int> nodeAt(f_.order.size());
    for (int t = 0; t < f_.nodeCount(); ++t)
      std::fill(nodeAt.begin() + f_.nodeStart[t], nodeAt.begin() + f_.nodeStart[t + 1], t);
    std::vector<int> nodeOf(static_cast<std::size_t>(elements_.count)), unknowns;
    start_.assign(static_cast<std::size_t>(f_.nodeCount()) + 1, 0);
    for (int e = 0; e < elements_.count; ++e) {
      elements_.unknownsOf(e, unknowns);
      int first = f_.size() - 1;
      for (const int unknown : unknowns) first = std::min(first, f_.position[unknown]);
      nodeOf[e] = nodeAt[first];
      ++start_[nodeOf[e] + 1];
    }
    for (std::size_t t = 1; t < start_.size(); ++t) start_[t] += start_[t - 1];
    std::vector<int> next(start_.begin(), start_.end() - 1);
    list_.resize(static_cast<std::size_t>(elements_.count));
    for (int e = 0; e < elements_.count; ++e) list_[next[nodeOf[e]]++] = e;
  }

  template <class Add, class AddToC>
  void addElements(int t, FormElements::Element& element, const AddToC& addToC,
                   const Add& add) const {
    for (int at = start_[t]; at < start_[t + 1]; ++at) {
      elements_.get(list_[at], element);
      const std::vector<int>& unknowns = element.unknowns;
      for (std::size_t j = 0; j < unknowns.size(); ++j) {
        const int column = f_.position[unknowns[j]];
        addToC(column, element.c[static_cast<Eigen::Index>(j)]);
        for (std::size_t i = j; i < unknowns.size(); ++i) {
          const int row = f_.position[unknowns[i]];
          const Complex value =
              element.H(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
          row >= column ? add(row, column, value) : add(column, row, std::conj(value));
        }
      }
    }
  }

  /// Elements among kept unknowns only.
  void addToRoot(int t, FormElements::Element& element) {
    addElements(t, element, addToC(), [&](int row, int column, const Complex& value) {
      addToKept(lu_.keptAt[row], lu_.keptAt[column], value);
    });
  }
  void addToKept(int row, int column, const Complex& value) {
    row >= column ? result_.H(row, column) += value : result_.H(column, row) += std::conj(value);
  }
  void addToResult(int t, const Complex* complement) {
    const int r = f_.rowCount(t);
    const int* rows = f_.rowsOf(t);
    for (int j = 0; j < r; ++j)
      for (int i = j; i < r; ++i)
        addToKept(lu_.keptAt[rows[i]], lu_.keptAt[rows[j]],
                  complement[static_cast<std::size_t>(j) * r + i]);
  }

  template <class AddToC>
  FormFront assemble(int t, FormScratch& scratch, const AddToC& addToC) const {
    std::vector<int>& local = scratch.local;
    const int s = f_.pivots(t), r = f_.rowCount(t);
    for (int k = 0; k < s; ++k) local[f_.nodeStart[t] + k] = k;
    for (int i = 0; i < r; ++i) local[f_.rowsOf(t)[i]] = s + i;
    FormFront front{s, r, {}, allocateComplex(static_cast<std::size_t>(r) * r)};
    front.panel.assign(static_cast<std::size_t>(s) * (s + r), 0.0);
    std::fill(front.below(), front.below() + static_cast<std::size_t>(r) * r, Complex(0.0));
    addElements(t, scratch.element, addToC, [&](int row, int column, const Complex& value) {
      front.add(local[row], local[column], value);
    });
    return front;
  }

  /// Rows ascend in both fronts, so that lower triangles go to lower triangles.
  void addChild(int child, const Complex* values, const std::vector<int>& local,
                FormFront& front) const {
    const int count = f_.rowCount(child);
    const int* rows = f_.rowsOf(child);
    for (int j = 0; j < count; ++j)
      for (int i = j; i < count; ++i)
        front.add(local[rows[i]], local[rows[j]], values[static_cast<std::size_t>(j) * count + i]);
  }

  /// N with x_e = −Nᴴ x_a for the pivots e and rows a of t: N T = U_eaᴴ with T = U_eeᴴ, lower triangular.
  void solveN(int t, FormScratch& scratch) const {
    std::vector<Complex>&n = scratch.n, &transposed = scratch.transposed;
    const int s = f_.pivots(t), r = f_.rowCount(t), ld = s + r;
    const Complex* U = lu_.panel(t);
    n.resize(static_cast<std::size_t>(r) * s);
    for (int j = 0; j < s; ++j)
      std::copy(U + static_cast<std::size_t>(j) * ld + s, U + static_cast<std::size_t>(j + 1) * ld,
                n.begin() + static_cast<std::ptrdiff_t>(j) * r);
    for (int end = s; end > 0; end -= std::min(end, kBlock)) {
      const int begin = std::max(0, end - kBlock), width = end - begin, later = s - end;
      if (later > 0) {
        transposed.resize(static_cast<std::size_t>(width) * later);
        for (int k = 0; k < later; ++k)
          for (int j = 0; j < width; ++j)
            transposed[static_cast<std::size_t>(k) * width + j] =
                std::conj(U[static_cast<std::size_t>(begin + j) * ld + end + k]);
        kernels().updateComplex(
            {r, width, later, raw(n.data() + static_cast<std::size_t>(end) * r),
             raw(transposed.data()), raw(n.data() + static_cast<std::size_t>(begin) * r), r, width,
             r, false, false},
            scratch.work.data());
      }
      for (int j = end - 1; j >= begin; --j) {
        Complex* column = n.data() + static_cast<std::size_t>(j) * r;
        const Complex* T = U + static_cast<std::size_t>(j) * ld;
        for (int k = j + 1; k < end; ++k)
          subtractMultiple(r, n.data() + static_cast<std::size_t>(k) * r, T[k], column);
        for (int i = 0; i < r; ++i) column[i] = portable::divide(column[i], T[j]);
      }
    }
  }

  /// With Y = H_ae − ½ N H_ee:  H_aa −= N Yᴴ + Y Nᴴ,  c_a −= N c_e.
  template <class AddToC>
  void eliminate(int t, FormFront& front, FormScratch& scratch, const AddToC& addToC) const {
    const int s = front.s, r = front.r, ld = s + r;
    std::vector<Complex>&n = scratch.n, &y = scratch.y, &half = scratch.half;
    solveN(t, scratch);
    y.resize(static_cast<std::size_t>(r) * s);
    half.resize(static_cast<std::size_t>(s) * s);
    for (int j = 0; j < s; ++j) {
      const Complex* column = front.panel.data() + static_cast<std::size_t>(j) * ld;
      std::copy(column + s, column + ld, y.begin() + static_cast<std::ptrdiff_t>(j) * r);
      for (int i = j; i < s; ++i) {
        half[static_cast<std::size_t>(j) * s + i] = 0.5 * column[i];
        half[static_cast<std::size_t>(i) * s + j] = 0.5 * std::conj(column[i]);
      }
    }
    const auto& update = kernels().updateComplex;
    update({r, s, s, raw(n.data()), raw(half.data()), raw(y.data()), r, s, r, false, false},
           scratch.work.data());
    double* const below = raw(front.below());
    update({r, r, s, raw(n.data()), raw(y.data()), below, r, r, r, true, false},
           scratch.work.data());
    update({r, r, s, raw(y.data()), raw(n.data()), below, r, r, r, true, false},
           scratch.work.data());
    for (int j = 0; j < s; ++j) {
      const Complex c = c_[f_.nodeStart[t] + j];
      for (int i = 0; i < r; ++i)
        addToC(f_.rowsOf(t)[i], -(n[static_cast<std::size_t>(j) * r + i] * c));
    }
  }

  const SchurLu::State& lu_;
  const SymbolicFactor& f_;
  const FormElements& elements_;
  std::vector<int> start_, list_;
  std::vector<std::unique_ptr<double[]>> held_;  // complements that their parents have not taken
  std::vector<std::vector<int>> children_;
  Eigen::VectorXcd c_;  // by position
  QuadraticForm result_;
};

}  // namespace

QuadraticForm SchurLu::restrict(const FormElements& elements) const {
  return FormRestriction(*state_, elements).run();
}

}  // namespace hgp::linalg
