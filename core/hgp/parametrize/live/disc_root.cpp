// What DragDisc factors once: the rows outside the disc, with a dense root over few kept unknowns, or all of them.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "hgp/base/portable_math.h"
#include "hgp/optimize/harmonic_rows.h"
#include "hgp/parametrize/live/drag_disc.h"
#include "hgp/system/square_rows.h"

namespace hgp::live {
namespace {

/// σ, as for soft constraints of a run.
constexpr double kSoft = 0.3;
/// Weight of rows that hold exactly, over that of others.
constexpr double kExact = 1e3;

/// First the unknowns outside the disc, then those of the disc as the root.
linalg::SeparatorTree twoNodes(int outside, int all) {
  linalg::SeparatorTree tree;
  tree.order.resize(at(all));
  std::iota(tree.order.begin(), tree.order.end(), 0);
  tree.nodeStart = {0, outside, all};
  tree.parent = {1, -1};
  if (outside > 0) return tree;
  tree.nodeStart = {0, all};
  tree.parent = {-1};
  return tree;
}

}  // namespace

double DragDisc::rowWeight(VertexId v, bool isSoft) const {
  return portable::exp(-setup_.field.u[v]) * (isSoft ? 1.0 : kExact);
}

SoftFace DragDisc::softFace(FaceId f) const {
  const Geometry& geometry = setup_.context->geometry;
  SoftFace out;
  out.face = f;
  out.weight2 = kSoft * geometry.area[f] * portable::exp(-2.0 * scaleAt(f));
  const FaceTerms anchor = faceTerms(geometry, still_, f);
  out.fz = valueOf(anchor.similar, x_);
  out.fzbar = valueOf(anchor.anti, x_);
  for (const Term& t : anchor.similar)
    if (t.unknown != held_) out.similar.push_back({index_[at(t.unknown)], t.factor});
  for (const Term& t : anchor.anti)
    if (t.unknown != held_) out.anti.push_back({index_[at(t.unknown)], t.factor});
  return out;
}

/// Mean of u over the corners.
double DragDisc::scaleAt(FaceId f) const {
  double u = 0.0;
  for (VertexId v : mesh_.corners(f)) u += setup_.field.u[v] / 3.0;
  return u;
}

/// Soft triangles out of reach, and the similarity between x* and the field, fitted over all soft triangles.
bool DragDisc::readFaces() {
  Complex fitted = 0.0;
  double area = 0.0;
  const auto fit = [&](const SoftFace& face) {
    const double u = scaleAt(face.face);
    fitted += face.weight2 * portable::polar(portable::exp(u), setup_.seams.frameAngle[face.face]) *
              face.fz;
    area += face.weight2 * portable::exp(2.0 * u);
  };
  for (FaceId f : far_) {
    farFaces_.push_back(softFace(f));
    fit(farFaces_.back());
    farFaces_.back().weight2 *= stiffness(farFaces_.back().fz, farFaces_.back().fzbar);
  }
  for (FaceId f : facesNear(cone_)) fit(softFace(f));
  scale_ = fitted / area;
  return std::norm(scale_) > 0.0 && std::isfinite(std::norm(scale_));
}

/// The harmonic rows that no move changes, each at the index of its vertex' unknown.
SparseRows DragDisc::outerRows() const {
  const SparseRows& rows = setup_.harmonic.rows;
  const auto count = static_cast<std::size_t>(setup_.unknowns.count);
  std::vector<int> start(count + 1, 0), column;
  std::vector<Complex> value;
  std::size_t row = 0;
  for (std::size_t r = 0; r < setup_.harmonic.rowVertex.size(); ++r) {
    const VertexId v = setup_.harmonic.rowVertex[r];
    if (ring_[v] >= 0 && ring_[v] < rings_) continue;
    const auto unknown = at(setup_.unknowns.vertexUnknown[v]);
    for (; row < unknown; ++row) start[row + 1] = static_cast<int>(column.size());
    for (SparseRows::InnerIterator it(rows, static_cast<Eigen::Index>(r)); it; ++it) {
      column.push_back(static_cast<int>(it.col()));
      value.push_back(it.value());
    }
  }
  for (; row < count; ++row) start[row + 1] = static_cast<int>(column.size());
  return Eigen::Map<const SparseRows::Matrix>(setup_.unknowns.count, setup_.unknowns.count,
                                              static_cast<Eigen::Index>(column.size()),
                                              start.data(), column.data(), value.data());
}

bool DragDisc::factor(const Eigen::SparseMatrix<Complex>& H, const linalg::SeparatorTree& tree) {
  linalg::PartialCholeskyOptions options;
  options.tree = &tree;
  options.delayDepth = 0;
  std::vector<int> clique;
  for (int unknown : disc_) clique.push_back(index_[at(unknown)]);
  if (!root_.build(H, {clique}, options)) return false;
  const Eigen::MatrixXcd reduced = root_.reducedForm();
  outside_.resize(reduced.rows(), reduced.cols());
  for (Eigen::Index j = 0; j < reduced.cols(); ++j)
    for (Eigen::Index i = 0; i < reduced.rows(); ++i)
      outside_(i, j) = reduced(rootIndex(i), rootIndex(j));
  return true;
}

/// Eliminates exact rows, which leaves a dense form over the kept unknowns.
bool DragDisc::buildDense() {
  if (!lu_.build(outerRows(), kept_, unknownTree(systemOf(mesh_, setup_), setup_.context->tree)))
    return false;
  const auto count = static_cast<Eigen::Index>(kept_.size());
  Eigen::VectorXd weight = Eigen::VectorXd::Ones(count);
  for (VertexId v : setup_.harmonic.rowVertex) {
    const int unknown = setup_.unknowns.vertexUnknown[v];
    const auto in = std::lower_bound(kept_.begin(), kept_.end(), unknown);
    if (in != kept_.end() && *in == unknown)
      weight[in - kept_.begin()] = rowWeight(v, isSoft_[v] != 0);
  }
  const Eigen::MatrixXcd gram = lu_.gram(weight);
  Eigen::MatrixXcd H = Eigen::MatrixXcd::Zero(count - 1, count - 1);
  for (Eigen::Index j = 0; j < count; ++j)
    for (Eigen::Index i = j; i < count; ++i) {
      const int a = index_[at(kept_[at(i)])], b = index_[at(kept_[at(j)])];
      if (a < 0 || b < 0) continue;
      H(a, b) = gram(i, j);
      H(b, a) = std::conj(gram(i, j));
    }
  for (const SoftFace& face : farFaces_)
    for (const Terms* part : {&face.similar, &face.anti})
      for (const Term& b : *part)
        for (const Term& a : *part)
          H(a.unknown, b.unknown) += face.weight2 * std::conj(a.factor) * b.factor;
  const int all = static_cast<int>(count) - 1;
  return factor(H.sparseView(), twoNodes(all - unknownCount(), all));
}

/// All rows as weighted ones: where a dense root would be too large.
bool DragDisc::buildSparse() {
  const int count = setup_.unknowns.count;
  for (int i = 0, next = 0; i < count; ++i) index_[at(i)] = i == held_ ? -1 : next++;
  SquareRows<Complex> sum(count - 1);
  for (std::size_t r = 0; r < setup_.harmonic.rowVertex.size(); ++r) {
    const VertexId v = setup_.harmonic.rowVertex[r];
    if (ring_[v] >= 0 && ring_[v] < rings_) continue;
    const double weight = rowWeight(v, isSoft_[v] != 0);
    for (SparseRows::InnerIterator it(setup_.harmonic.rows, static_cast<Eigen::Index>(r)); it; ++it)
      if (const int index = index_[at(it.col())]; index >= 0) sum.add(index, weight * it.value());
    sum.endRow();
  }
  farFaces_.clear();  // they were read with the numbers of the dense form
  if (!readFaces()) return false;
  for (const SoftFace& face : farFaces_)
    for (const Terms* part : {&face.similar, &face.anti}) {
      for (const Term& t : *part) sum.add(t.unknown, std::sqrt(face.weight2) * t.factor);
      sum.endRow();
    }
  std::vector<int> numbers = setup_.unknowns.vertexUnknown.raw();
  for (int& unknown : numbers)
    if (unknown >= 0) unknown = index_[at(unknown)];
  const Eigen::SparseMatrix<Complex> H = sum.takeForm();
  return factor(H, formTree(setup_.context->wideTree->get(), numbers, H));
}

}  // namespace hgp::live
