#include <algorithm>

#include "hgp/base/portable_math.h"
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

class FormRestriction {
 public:
  FormRestriction(const SchurLu::State& lu, const FormElements& elements)
      : lu_(lu), f_(lu.symbolic), elements_(elements), local_(f_.order.size()), c_(f_.size()) {
    c_.setZero();
    result_.H.setZero(static_cast<Eigen::Index>(lu.kept.size()),
                      static_cast<Eigen::Index>(lu.kept.size()));
  }

  QuadraticForm run() {
    groupElements();
    std::vector<std::unique_ptr<double[]>> held(static_cast<std::size_t>(f_.nodeCount()));
    std::vector<std::vector<int>> children(held.size());
    for (int t = 0; t < f_.nodeCount(); ++t) {
      if (f_.dynamicNode[t]) {
        addToRoot(t);
        continue;
      }
      FormFront front = assemble(t);
      for (const int child : children[t]) {
        addChild(child, reinterpret_cast<const Complex*>(held[child].get()), front);
        held[child].reset();
      }
      if (front.r == 0) continue;
      eliminate(t, front);
      if (f_.dynamicNode[f_.parent[t]]) {
        addToResult(t, front.below());
        continue;
      }
      children[f_.parent[t]].push_back(t);
      held[t] = std::move(front.complement);
    }
    result_.H = Eigen::MatrixXcd(result_.H.selfadjointView<Eigen::Lower>());
    result_.c.resize(result_.H.rows());
    for (int k = 0; k < f_.size(); ++k)
      if (lu_.keptAt[k] >= 0) result_.c[lu_.keptAt[k]] = c_[k];
    return std::move(result_);
  }

 private:
  /// Elements by the node of their first unknown.
  void groupElements() {
    std::vector<int> nodeAt(f_.order.size());
    for (int t = 0; t < f_.nodeCount(); ++t)
      std::fill(nodeAt.begin() + f_.nodeStart[t], nodeAt.begin() + f_.nodeStart[t + 1], t);
    std::vector<int> nodeOf(static_cast<std::size_t>(elements_.count));
    start_.assign(static_cast<std::size_t>(f_.nodeCount()) + 1, 0);
    for (int e = 0; e < elements_.count; ++e) {
      elements_.unknownsOf(e, element_.unknowns);
      int first = f_.size() - 1;
      for (const int unknown : element_.unknowns) first = std::min(first, f_.position[unknown]);
      nodeOf[e] = nodeAt[first];
      ++start_[nodeOf[e] + 1];
    }
    for (std::size_t t = 1; t < start_.size(); ++t) start_[t] += start_[t - 1];
    std::vector<int> next(start_.begin(), start_.end() - 1);
    list_.resize(static_cast<std::size_t>(elements_.count));
    for (int e = 0; e < elements_.count; ++e) list_[next[nodeOf[e]]++] = e;
  }

  template <class Add>
  void addElements(int t, const Add& add) {
    for (int at = start_[t]; at < start_[t + 1]; ++at) {
      elements_.get(list_[at], element_);
      const std::vector<int>& unknowns = element_.unknowns;
      for (std::size_t j = 0; j < unknowns.size(); ++j) {
        const int column = f_.position[unknowns[j]];
        c_[column] += element_.c[static_cast<Eigen::Index>(j)];
        for (std::size_t i = j; i < unknowns.size(); ++i) {
          const int row = f_.position[unknowns[i]];
          const Complex value =
              element_.H(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
          row >= column ? add(row, column, value) : add(column, row, std::conj(value));
        }
      }
    }
  }

  /// Elements among kept unknowns only.
  void addToRoot(int t) {
    addElements(t, [&](int row, int column, const Complex& value) {
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

  FormFront assemble(int t) {
    const int s = f_.pivots(t), r = f_.rowCount(t);
    for (int k = 0; k < s; ++k) local_[f_.nodeStart[t] + k] = k;
    for (int i = 0; i < r; ++i) local_[f_.rowsOf(t)[i]] = s + i;
    FormFront front{s, r, {}, allocateComplex(static_cast<std::size_t>(r) * r)};
    front.panel.assign(static_cast<std::size_t>(s) * (s + r), 0.0);
    std::fill(front.below(), front.below() + static_cast<std::size_t>(r) * r, Complex(0.0));
    addElements(t, [&](int row, int column, const Complex& value) {
      front.add(local_[row], local_[column], value);
    });
    return front;
  }

  /// Rows ascend in both fronts, so that lower triangles go to lower triangles.
  void addChild(int child, const Complex* values, FormFront& front) const {
    const int count = f_.rowCount(child);
    const int* rows = f_.rowsOf(child);
    for (int j = 0; j < count; ++j)
      for (int i = j; i < count; ++i)
        front.add(local_[rows[i]], local_[rows[j]],
                  values[static_cast<std::size_t>(j) * count + i]);
  }

  /// N with x_e = −Nᴴ x_a for the pivots e and rows a of t: N T = U_eaᴴ with T = U_eeᴴ, lower triangular.
  void solveN(int t) {
    const int s = f_.pivots(t), r = f_.rowCount(t), ld = s + r;
    const Complex* U = lu_.panel(t);
    n_.resize(static_cast<std::size_t>(r) * s);
    for (int j = 0; j < s; ++j)
      std::copy(U + static_cast<std::size_t>(j) * ld + s, U + static_cast<std::size_t>(j + 1) * ld,
                n_.begin() + static_cast<std::ptrdiff_t>(j) * r);
    for (int end = s; end > 0; end -= std::min(end, kBlock)) {
      const int begin = std::max(0, end - kBlock), width = end - begin, later = s - end;
      if (later > 0) {
        transposed_.resize(static_cast<std::size_t>(width) * later);
        for (int k = 0; k < later; ++k)
          for (int j = 0; j < width; ++j)
            transposed_[static_cast<std::size_t>(k) * width + j] =
                std::conj(U[static_cast<std::size_t>(begin + j) * ld + end + k]);
        kernels().updateComplex(
            {r, width, later, raw(n_.data() + static_cast<std::size_t>(end) * r),
             raw(transposed_.data()), raw(n_.data() + static_cast<std::size_t>(begin) * r), r,
             width, r, false, false},
            work_.data());
      }
      for (int j = end - 1; j >= begin; --j) {
        Complex* column = n_.data() + static_cast<std::size_t>(j) * r;
        const Complex* T = U + static_cast<std::size_t>(j) * ld;
        for (int k = j + 1; k < end; ++k)
          subtractMultiple(r, n_.data() + static_cast<std::size_t>(k) * r, T[k], column);
        for (int i = 0; i < r; ++i) column[i] = portable::divide(column[i], T[j]);
      }
    }
  }

  /// With Y = H_ae − ½ N H_ee:  H_aa −= N Yᴴ + Y Nᴴ,  c_a −= N c_e.
  void eliminate(int t, FormFront& front) {
    const int s = front.s, r = front.r, ld = s + r;
    solveN(t);
    y_.resize(static_cast<std::size_t>(r) * s);
    half_.resize(static_cast<std::size_t>(s) * s);
    for (int j = 0; j < s; ++j) {
      const Complex* column = front.panel.data() + static_cast<std::size_t>(j) * ld;
      std::copy(column + s, column + ld, y_.begin() + static_cast<std::ptrdiff_t>(j) * r);
      for (int i = j; i < s; ++i) {
        half_[static_cast<std::size_t>(j) * s + i] = 0.5 * column[i];
        half_[static_cast<std::size_t>(i) * s + j] = 0.5 * std::conj(column[i]);
      }
    }
    const auto& update = kernels().updateComplex;
    update({r, s, s, raw(n_.data()), raw(half_.data()), raw(y_.data()), r, s, r, false, false},
           work_.data());
    double* const below = raw(front.below());
    update({r, r, s, raw(n_.data()), raw(y_.data()), below, r, r, r, true, false}, work_.data());
    update({r, r, s, raw(y_.data()), raw(n_.data()), below, r, r, r, true, false}, work_.data());
    for (int j = 0; j < s; ++j) {
      const Complex c = c_[f_.nodeStart[t] + j];
      for (int i = 0; i < r; ++i)
        c_[f_.rowsOf(t)[i]] -= n_[static_cast<std::size_t>(j) * r + i] * c;
    }
  }

  const SchurLu::State& lu_;
  const SymbolicFactor& f_;
  const FormElements& elements_;
  std::vector<int> local_, start_, list_;
  std::vector<Complex> n_, y_, half_, transposed_;
  FormElements::Element element_;
  KernelWorkspace work_;
  Eigen::VectorXcd c_;  // by position
  QuadraticForm result_;
};

}  // namespace

QuadraticForm SchurLu::restrict(const FormElements& elements) const {
  return FormRestriction(*state_, elements).run();
}

}  // namespace hgp::linalg
