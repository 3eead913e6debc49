#include "hgp/grid/grid_system.h"

#include <cmath>

#include "hgp/base/portable_math.h"
#include "hgp/grid/snap.h"

namespace hgp {
namespace {

Complex complexAt(const std::vector<Vec2>& uv, int copy) {
  return {uv[at(copy)][0], uv[at(copy)][1]};
}

/// Multiply-adds per triangle of reading seams and assembling and ordering the form (measured).
constexpr double kFormWork = 3e3;
/// Multiply-adds of the dense part, divided by n³ for n translations: the form in a reduced basis, and its factor
/// (measured).
constexpr double kDenseWork = 1.0;

std::int64_t gapNorm(int turn) { return norm(Gaussian{1, 0} - quarterTurn(turn)); }

}  // namespace

GridSystem::GridSystem(const TriMesh& mesh, const UvMap& map, int q, std::vector<VertexId> cones,
                       SeamStructure seams)
    : mesh_(mesh),
      map_(map),
      q_(q),
      cones_(std::move(cones)),
      seams_(std::move(seams)),
      uv_(map.uv) {}

std::unique_ptr<GridSystem> GridSystem::make(const TriMesh& mesh, const UvMap& map, int q,
                                             const std::vector<VertexId>& cones, GridMode mode,
                                             const linalg::SeparatorTree* tree) {
  std::optional<SeamStructure> seams = readSeams(mesh, map, q, cones);
  if (!seams) return nullptr;
  std::unique_ptr<GridSystem> system(new GridSystem(mesh, map, q, cones, std::move(*seams)));
  if (!system->build(mode, tree)) return nullptr;
  return system;
}

bool GridSystem::build(GridMode mode, const linalg::SeparatorTree* tree) {
  change_ = std::make_unique<SeamlessChange>(mesh_, seams_);
  if (mode == GridMode::kQuad)
    for (VertexId v : cones_)
      if (change_->vertexUnknown(v) >= 0) whole_.push_back(v);
  chooseOrigin();
  return solveIntegers(mode) && factor(tree);
}

void GridSystem::chooseOrigin() {
  Complex origin = 0.0;
  std::int64_t least = 5;
  for (const auto& closure : seams_.closures) {
    if (closure.place.turn == 0 || gapNorm(closure.place.turn) >= least) continue;
    least = gapNorm(closure.place.turn);
    gauge_ = closure.place.shift;
    origin = complexAt(uv_, seams_.firstCopy[closure.vertex]);
  }
  if (gauge_.empty() && !whole_.empty()) {
    origin = complexAt(uv_, seams_.firstCopy[whole_[0]]);
    gauge_ = {{seams_.chainCount(), {1, 0}}};
  }
  const std::vector<Complex> t = chainTranslations(seams_, mesh_, uv_);
  for (int c = 0; c < seams_.chainCount() && least > 2; ++c) {
    const int turn = seams_.chainTurn[at(c)];
    if (!gauge_.empty() || turn == 0) continue;
    gauge_ = {{c, {1, 0}}};
    origin = portable::divide(t[at(c)], 1.0 - toComplex(quarterTurn(turn)));
  }
  for (Vec2& p : uv_) p = {p[0] - origin.real(), p[1] - origin.imag()};
}

/// Variables: chains, then cones of `whole_`, then in quad mode the rotating cones.
bool GridSystem::solveIntegers(GridMode mode) {
  std::vector<GaussianSum> relations = closureRelations(seams_);
  const std::vector<Complex> t = chainTranslations(seams_, mesh_, uv_);
  Eigen::VectorXcd value(
      static_cast<Eigen::Index>(t.size() + whole_.size() + seams_.closures.size()));
  int variables = 0;
  bool isTurned = false;
  for (const Complex& z : t) value[variables++] = z;
  for (const int turn : seams_.chainTurn) isTurned = isTurned || turn != 0;
  for (VertexId v : whole_) value[variables++] = complexAt(uv_, seams_.firstCopy[v]);
  for (const auto& closure : seams_.closures) {
    if (mode != GridMode::kQuad || closure.place.turn == 0) continue;
    GaussianSum relation = closure.place.shift;
    relation.push_back({variables, quarterTurn(closure.place.turn) - Gaussian{1, 0}});
    relations.push_back(std::move(relation));
    value[variables++] = complexAt(uv_, seams_.firstCopy[closure.vertex]);
  }
  if (!gauge_.empty()) relations.push_back(gauge_);
  std::optional<IntegerBasis> basis = solveRelations(variables, relations);
  if (!basis) return false;
  basis_ = std::move(*basis);

  for (int c = 0; c < seams_.chainCount(); ++c) heldUnknowns_.push_back(change_->chainUnknown(c));
  for (VertexId v : whole_) heldUnknowns_.push_back(change_->vertexUnknown(v));
  const auto fromIntegers = static_cast<Eigen::Index>(heldUnknowns_.size());
  if (!isTurned && whole_.empty()) heldUnknowns_.push_back(0);  // fixes the map's translation
  rows_.resize(static_cast<Eigen::Index>(heldUnknowns_.size()), basis_.size());
  std::vector<Eigen::Triplet<Complex>> entries;
  held0_ = Eigen::VectorXcd::Zero(rows_.rows());
  for (Eigen::Index i = 0; i < fromIntegers; ++i) {
    for (const GaussianTerm& term : basis_.value[at(i)])
      entries.emplace_back(static_cast<int>(i), term.variable, toComplex(term.factor));
    held0_[i] = value[i];
  }
  rows_.setFromTriplets(entries.begin(), entries.end());
  y0_ = Eigen::VectorXcd::Zero(basis_.size());
  for (int j = 0; j < basis_.size(); ++j)
    for (const GaussianTerm& term : basis_.coordinate[at(j)])
      y0_[j] += toComplex(term.factor) * value[term.variable];
  return true;
}

linalg::SeparatorTree GridSystem::freeTree(const linalg::SeparatorTree& vertexTree) const {
  // The tree needs ids 0 … n − 1 without gaps; held vertices are appended afterwards.
  std::vector<int> numbers = change_->vertexUnknowns(), list;
  for (int u : numbers)
    if (u >= 0 && !isHeld_[at(u)]) list.push_back(u);
  const FreeUnknowns free(list, change_->count());
  for (int& u : numbers)
    if (u >= 0) u = free.number(u);
  linalg::SeparatorTree own = linalg::restrictTree(vertexTree, numbers);
  for (int& u : own.order) u = free.unknownOf()[at(u)];
  for (int u : heldUnknowns_) own.order.push_back(u);
  own.nodeStart.back() = static_cast<int>(own.order.size());
  return own;
}

bool GridSystem::factor(const linalg::SeparatorTree* tree) {
  weights_ = strainWeights(mesh_, seams_, uv_);
  isHeld_.assign(at(change_->count()), 0);
  std::vector<FaceId> all;
  for (FaceId f : mesh_.faces()) all.push_back(f);
  const StrainForm strain = strainForm({mesh_, seams_, *change_, uv_, weights_}, all,
                                       FreeUnknowns(isHeld_), Eigen::VectorXcd());
  for (int u : heldUnknowns_) isHeld_[at(u)] = 1;
  linalg::PartialCholeskyOptions options;
  options.delayDepth = 0;
  linalg::SeparatorTree own;
  if (tree) {
    own = freeTree(*tree);
    options.tree = &own;
  }
  if (heldUnknowns_.empty()) {
    integers_ = std::make_shared<const IntegerForm>(Eigen::MatrixXcd(0, 0));
    return true;
  }
  if (!cholesky_.build(strain.H, {heldUnknowns_}, options)) return false;
  const auto n = static_cast<Eigen::Index>(heldUnknowns_.size());
  const Eigen::MatrixXcd reduced = cholesky_.reducedForm();
  Eigen::MatrixXcd form(n, n);
  for (Eigen::Index j = 0; j < n; ++j)
    for (Eigen::Index i = 0; i < n; ++i)
      form(i, j) = reduced(cholesky_.dynamicIndex(heldUnknowns_[at(i)]),
                           cholesky_.dynamicIndex(heldUnknowns_[at(j)]));
  const Eigen::MatrixXcd half = form * rows_;
  integers_ = std::make_shared<const IntegerForm>(rows_.adjoint() * half);
  return true;
}

ConeNeighbours GridSystem::neighbours(double reach) const {
  return neighbouringCones(mesh_, seams_, *change_, uv_, cones_, reach);
}

IntegerChoice GridSystem::choice(double reach) const {
  std::vector<int> rowOf(at(change_->count()), -1);
  for (std::size_t i = 0; i < heldUnknowns_.size(); ++i)
    rowOf[at(heldUnknowns_[i])] = static_cast<int>(i);
  /// `way` in terms of y; empty if it depends on a cone that is not restricted to integers.
  const auto inIntegers = [&](const std::vector<SeamlessChange::Term>& way) {
    Eigen::VectorXcd sum = Eigen::VectorXcd::Zero(basis_.size());
    std::vector<std::pair<int, Complex>> terms;
    for (const SeamlessChange::Term& term : way) {
      const int row = rowOf[at(term.unknown)];
      if (row < 0) return terms;
      for (decltype(rows_)::InnerIterator entry(rows_, row); entry; ++entry)
        sum[entry.col()] += term.factor * entry.value();
    }
    for (int j = 0; j < basis_.size(); ++j)
      if (portable::abs(sum[j]) > 1e-9) terms.push_back({j, sum[j]});
    return terms;
  };
  std::vector<Separation> separations;
  const ConeNeighbours near = neighbours(reach);
  for (const ConePair& pair : near.pairs) {
    Separation s{inIntegers(pair.way)};
    if (!s.terms.empty()) separations.push_back(std::move(s));
  }
  for (const ConeTriangle& triangle : near.triangles) {
    Separation s{inIntegers(triangle.ab.way), inIntegers(triangle.ac.way)};
    if (!s.terms.empty() && !s.second.empty()) separations.push_back(std::move(s));
  }
  return IntegerChoice(integers_, std::move(separations));
}

double GridSystem::factorWork() const {
  const double beside = kFormWork * mesh_.faceCount();
  if (heldUnknowns_.empty()) return beside;
  const auto held = static_cast<double>(heldUnknowns_.size());
  return linalg::multiplyAdds(cholesky_.report(), 0) + beside + kDenseWork * held * held * held;
}

double GridSystem::solveWork() const {
  return heldUnknowns_.empty() ? 0.0
                               : 8.0 * static_cast<double>(cholesky_.report().staticCost.entries);
}

Eigen::VectorXcd GridSystem::changeTo(const std::vector<Gaussian>& y, double scale) const {
  Eigen::VectorXcd chosen(basis_.size());
  for (int j = 0; j < basis_.size(); ++j) chosen[j] = toComplex(y[at(j)]) / scale;
  if (heldUnknowns_.empty()) return Eigen::VectorXcd::Zero(change_->count());
  const Eigen::VectorXcd held = rows_ * chosen - held0_;
  Eigen::VectorXd reduced(2 * held.size());
  for (std::size_t i = 0; i < heldUnknowns_.size(); ++i) {
    const auto index = 2 * cholesky_.dynamicIndex(heldUnknowns_[i]);
    const Complex z = held[static_cast<Eigen::Index>(i)];
    reduced[index] = z.real();
    reduced[index + 1] = z.imag();
  }
  return cholesky_.extend(reduced, Eigen::VectorXcd::Zero(change_->count()));
}

std::optional<UvMap> GridSystem::alignedMap(const Eigen::VectorXcd& x, double scale) const {
  const std::vector<Complex> dz = change_->evaluate(x);
  UvMap out = map_;
  for (std::size_t c = 0; c < dz.size(); ++c)
    out.uv[c] = {scale * (uv_[c][0] + dz[c].real()), scale * (uv_[c][1] + dz[c].imag())};
  for (VertexId v : whole_) {
    Vec2& p = out.uv[at(seams_.firstCopy[v])];
    p = {std::nearbyint(p[0]), std::nearbyint(p[1])};
  }
  return snapAligned(mesh_, std::move(out), q_, cones_);
}

}  // namespace hgp
