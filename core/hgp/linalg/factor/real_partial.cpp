#include "hgp/linalg/factor/real_partial.h"

#include "hgp/base/portable_math.h"
#include "hgp/linalg/factor/diagonal_lifts.h"
#include "hgp/linalg/factor/matrix_source.h"
#include "hgp/linalg/ordering/delay.h"

namespace hgp::linalg {
namespace {

/// The plan of delays counts a changing unknown as two real ones and a static one as half of that, in complex arithmetic.
/// Here both are real, so that half the usual number of iterations weighs the same.
constexpr int kIterations = 6;

/// By position in the elimination order; of `A`, the columns that are not empty.
void addDiagonal(const Eigen::SparseMatrix<double>& A, const SymbolicFactor& f,
                 std::vector<double>& diagonal) {
  for (int j = 0; j < f.size(); ++j)
    if (A.outerIndexPtr()[j] < A.outerIndexPtr()[j + 1])
      diagonal[f.position[j]] += portable::abs(A.coeff(j, j));
}

}  // namespace

void RealPartialCholesky::build(const Sparse& H, const SeparatorTree& tree,
                                const Cliques& cliques) {
  H_ = &H;
  const Graph pattern = withCliques(graphOf(H), cliques);
  SymbolicOptions options;
  options.dynamic.assign(static_cast<std::size_t>(pattern.size()), 0);
  for (const std::vector<int>& clique : cliques)
    for (const int v : clique) options.dynamic[v] = 1;
  const DelayedOrder delayed = delayTouched(pattern, tree, cliques, {kIterations});
  symbolic_ =
      std::make_shared<const SymbolicFactor>(linalg::analyze(pattern, delayed.order, options));
  const SymbolicFactor& f = *symbolic_;
  isReduced_.assign(f.order.size(), 0);
  for (int t = 0; t < f.nodeCount(); ++t)
    for (int k = f.nodeStart[t]; k < f.nodeStart[t + 1]; ++k) isReduced_[k] = f.dynamicNode[t];
  diagonal_.assign(f.order.size(), 0.0);
  addDiagonal(H, f, diagonal_);
  statics_.layOut(symbolic_, 0);
  reduced_.layOut(symbolic_, 1);
  staticStatus_ = eliminate(nullptr, statics_, &complements_);
}

/// H, or H + blocks, in the nodes of `panels`; its diagonal is lifted where that is necessary.
FactorStatus RealPartialCholesky::eliminate(const Sparse* blocks, PanelFactor<double>& panels,
                                            std::vector<Contribution<double>>* left) const {
  const SymbolicFactor& f = *symbolic_;
  std::vector<double> diagonal = diagonal_;
  const FrontSource<double> own = matrixSource(*H_, f);
  FrontSource<double> changing;
  if (blocks != nullptr) {
    addDiagonal(*blocks, f, diagonal);
    changing = matrixSource(*blocks, f);
  }
  return withLifts([&](double lift) {
    FrontSource<double> source;
    source.addToPanel = [&](int t, const int* local, double* panel, int rows) {
      own.addToPanel(t, local, panel, rows);
      if (blocks != nullptr) changing.addToPanel(t, local, panel, rows);
      for (int k = 0; k < f.pivots(t); ++k)
        panel[static_cast<std::size_t>(k) * rows + k] += lift * diagonal[f.nodeStart[t] + k];
    };
    if (blocks != nullptr) source.below = &complements_;
    FactorStatus status = panels.eliminate(source, diagonal, left);
    if (!status) status.badPivot = f.order[status.badPivot];
    return status;
  });
}

Eigen::MatrixXd RealPartialCholesky::byPosition(const Eigen::VectorXd& x) const {
  Eigen::MatrixXd out(x.size(), 1);
  for (int k = 0; k < symbolic_->size(); ++k) out(k, 0) = x[symbolic_->order[k]];
  return out;
}

Eigen::VectorXd RealPartialCholesky::reducedPart(const Eigen::MatrixXd& x) const {
  Eigen::VectorXd out = Eigen::VectorXd::Zero(x.rows());
  for (int k = 0; k < symbolic_->size(); ++k)
    if (isReduced_[k]) out[symbolic_->order[k]] = x(k, 0);
  return out;
}

Eigen::VectorXd RealPartialCholesky::reduceLinear(const Eigen::VectorXd& c) const {
  Eigen::MatrixXd x = byPosition(c);
  if (staticStatus_) statics_.forward(x);
  return reducedPart(x);
}

Eigen::VectorXd RealPartialCholesky::apply(const Eigen::VectorXd& x) const {
  // x is 0 at static unknowns, and what H adds to these is left out.
  Eigen::VectorXd y = reducedPart(byPosition(*H_ * x));
  Eigen::VectorXd in, out;
  for (int t = 0; t < symbolic_->nodeCount(); ++t) {
    if (symbolic_->dynamicNode[t] || complements_.empty() || !complements_[t].memory) continue;
    const int r = symbolic_->rowCount(t);
    const auto unknown = [&](int i) { return symbolic_->order[symbolic_->rowsOf(t)[i]]; };
    in.resize(r);
    for (int i = 0; i < r; ++i) in[i] = x[unknown(i)];
    const Eigen::Map<const Eigen::MatrixXd> complement(complements_[t].values(), r, r);
    out.noalias() = complement.selfadjointView<Eigen::Lower>() * in;
    for (int i = 0; i < r; ++i) y[unknown(i)] += out[i];
  }
  return y;
}

FactorStatus RealPartialCholesky::factor(const Sparse& blocks) {
  return staticStatus_ ? eliminate(&blocks, reduced_, nullptr) : staticStatus_;
}

Eigen::VectorXd RealPartialCholesky::solve(const Eigen::VectorXd& rhs) const {
  Eigen::MatrixXd x = byPosition(rhs);
  reduced_.forward(x);
  reduced_.backward(x);
  return reducedPart(x);
}

Eigen::VectorXd RealPartialCholesky::extend(const Eigen::VectorXd& reduced,
                                            const Eigen::VectorXd& c) const {
  if (!staticStatus_) return reduced;
  Eigen::MatrixXd x = byPosition(-c);
  statics_.forward(x);
  for (int k = 0; k < symbolic_->size(); ++k)
    if (isReduced_[k]) x(k, 0) = reduced[symbolic_->order[k]];
  statics_.backward(x);
  Eigen::VectorXd out(x.rows());
  for (int k = 0; k < symbolic_->size(); ++k) out[symbolic_->order[k]] = x(k, 0);
  return out;
}

}  // namespace hgp::linalg
