#include "hgp/linalg/factor/partial_cholesky.h"

#include "hgp/base/check.h"
#include "hgp/base/portable_math.h"
#include "hgp/linalg/factor/matrix_source.h"
#include "hgp/linalg/factor/reduced_system.h"
#include "hgp/linalg/ordering/delay.h"

namespace hgp::linalg {
namespace {

using Complex = std::complex<double>;
using ComplexSparse = Eigen::SparseMatrix<Complex>;

}  // namespace

struct PartialCholesky::State {
  std::shared_ptr<const SymbolicFactor> symbolic;
  PanelFactor<Complex> statics;
  ReducedSystem reduced;
  Report report;
};

PartialCholesky::PartialCholesky() : state_(std::make_unique<State>()) {}
PartialCholesky::~PartialCholesky() = default;
PartialCholesky::PartialCholesky(PartialCholesky&&) noexcept = default;
PartialCholesky& PartialCholesky::operator=(PartialCholesky&&) noexcept = default;

FactorStatus PartialCholesky::build(const ComplexSparse& H, const Cliques& cliques,
                                    const PartialCholeskyOptions& options) {
  HGP_CHECK(H.rows() == H.cols(), "H is %d × %d", static_cast<int>(H.rows()),
            static_cast<int>(H.cols()));
  state_ = std::make_unique<State>();
  const Graph pattern = withCliques(graphOf(H), cliques);
  SeparatorTree ownTree;
  if (options.tree == nullptr) ownTree = nestedDissection(pattern);
  const SeparatorTree& tree = options.tree != nullptr ? *options.tree : ownTree;
  HGP_CHECK(static_cast<int>(tree.order.size()) == pattern.size(), "tree of %d for %d unknowns",
            static_cast<int>(tree.order.size()), pattern.size());
  const DelayedOrder delayed = delayTouched(
      pattern, tree, cliques, {options.iterations, options.delayDepth, options.maxBytes});
  SymbolicOptions symbolicOptions;
  symbolicOptions.dynamic.assign(static_cast<std::size_t>(pattern.size()), 0);
  for (const std::vector<int>& clique : cliques)
    for (const int v : clique) symbolicOptions.dynamic[v] = 1;
  state_->symbolic =
      std::make_shared<const SymbolicFactor>(analyze(pattern, delayed.order, symbolicOptions));
  const SymbolicFactor& f = *state_->symbolic;
  std::vector<double> diagonal(f.order.size());
  for (int k = 0; k < f.size(); ++k) diagonal[k] = portable::abs(H.coeff(f.order[k], f.order[k]));
  state_->statics.layOut(state_->symbolic, 0);
  std::vector<Contribution<Complex>> complements;
  FactorStatus status = state_->statics.eliminate(matrixSource(H, f), diagonal, &complements);
  if (!status) {
    status.badPivot = f.order[status.badPivot];
    return status;
  }
  state_->reduced.build(f, H, cliques, std::move(complements));
  state_->report = {delayed.depth, factorCost(f, 0), state_->reduced.cost()};
  return status;
}

int PartialCholesky::size() const { return state_->symbolic ? state_->symbolic->size() : 0; }
int PartialCholesky::dynamicSize() const { return state_->reduced.count(); }
int PartialCholesky::dynamicIndex(int unknown) const {
  return state_->reduced.indexAt(state_->symbolic->position[unknown]);
}
const PartialCholesky::Report& PartialCholesky::report() const { return state_->report; }
std::size_t PartialCholesky::blockOffset(int b) const { return state_->reduced.offset(b); }
std::size_t PartialCholesky::blockStorage() const { return state_->reduced.storage(); }

Eigen::VectorXcd PartialCholesky::reduceLinear(const Eigen::VectorXcd& c) const {
  HGP_CHECK(c.size() == size(), "%d entries for %d unknowns", static_cast<int>(c.size()), size());
  Eigen::MatrixXcd x(size(), 1);
  for (int k = 0; k < size(); ++k) x(k, 0) = c[state_->symbolic->order[k]];
  state_->statics.forward(x);
  Eigen::VectorXcd reduced(dynamicSize());
  for (int d = 0; d < dynamicSize(); ++d) reduced[d] = x(state_->reduced.position(d), 0);
  return reduced;
}

Eigen::VectorXd PartialCholesky::apply(const Eigen::VectorXd& x) const {
  HGP_CHECK(x.size() == 2 * dynamicSize(), "%d entries for %d pairs", static_cast<int>(x.size()),
            dynamicSize());
  const Eigen::Map<const Eigen::VectorXcd> z(reinterpret_cast<const Complex*>(x.data()),
                                             dynamicSize());
  const Eigen::VectorXcd y = state_->reduced.apply(z);
  return Eigen::Map<const Eigen::VectorXd>(reinterpret_cast<const double*>(y.data()), x.size());
}

Eigen::MatrixXcd PartialCholesky::reducedForm() const { return state_->reduced.dense(); }

FactorStatus PartialCholesky::factor(const std::vector<Eigen::MatrixXd>& blocks) {
  HGP_CHECK(static_cast<int>(blocks.size()) == state_->reduced.blockCount(),
            "%d blocks for %d cliques", static_cast<int>(blocks.size()),
            state_->reduced.blockCount());
  std::vector<double> values(blockStorage());
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const std::size_t from = blockOffset(static_cast<int>(b));
    HGP_CHECK(
        static_cast<std::size_t>(blocks[b].size()) == blockOffset(static_cast<int>(b) + 1) - from,
        "block %zu has %d numbers", b, static_cast<int>(blocks[b].size()));
    Eigen::Map<Eigen::MatrixXd>(values.data() + from, blocks[b].rows(), blocks[b].cols()) =
        blocks[b];
  }
  return factor(values.data());
}

FactorStatus PartialCholesky::factor(const double* values) {
  FactorStatus status = state_->reduced.factor(values);
  if (!status) status.badPivot = state_->symbolic->order[state_->reduced.position(status.badPivot)];
  return status;
}

Eigen::VectorXd PartialCholesky::solve(const Eigen::VectorXd& rhs) const {
  return solve(Eigen::MatrixXd(rhs)).col(0);
}

Eigen::MatrixXd PartialCholesky::solve(const Eigen::MatrixXd& rhs) const {
  HGP_CHECK(state_->reduced.isFactored() && rhs.rows() == 2 * dynamicSize(),
            "no factor, or %d rows for %d pairs", static_cast<int>(rhs.rows()), dynamicSize());
  Eigen::MatrixXd x = rhs;
  state_->reduced.solveInPlace(x);
  return x;
}

Eigen::VectorXcd PartialCholesky::extend(const Eigen::VectorXd& xd,
                                         const Eigen::VectorXcd& c) const {
  HGP_CHECK(xd.size() == 2 * dynamicSize() && c.size() == size(), "%d reals and %d entries",
            static_cast<int>(xd.size()), static_cast<int>(c.size()));
  Eigen::MatrixXcd x(size(), 1);
  for (int k = 0; k < size(); ++k) x(k, 0) = -c[state_->symbolic->order[k]];
  state_->statics.forward(x);
  for (int d = 0; d < dynamicSize(); ++d)
    x(state_->reduced.position(d), 0) = Complex(xd[2 * d], xd[2 * d + 1]);
  state_->statics.backward(x);
  Eigen::VectorXcd result(size());
  for (int k = 0; k < size(); ++k) result[state_->symbolic->order[k]] = x(k, 0);
  return result;
}

}  // namespace hgp::linalg
