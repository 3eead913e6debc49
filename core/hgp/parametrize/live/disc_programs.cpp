// One frame of a drag: the two programs of DragDisc, which run again for every position of the cone.
#include <algorithm>

#include "hgp/base/portable_math.h"
#include "hgp/parametrize/live/drag_disc.h"

namespace hgp::live {
namespace {

/// Weight of soft terms beside frame conditions: a tie-break, as in the programs of a run.
constexpr double kTieBreak = 1e-5;

}  // namespace

int DragDisc::rootIndex(Eigen::Index inDisc) const {
  return root_.dynamicIndex(index_[at(disc_[at(inDisc)])]);
}

DiscFrame DragDisc::frameAt(const MovedCut& cut, const MovedField& field, VertexId to) const {
  const Complex gauge = gaugeOf(field);
  Eigen::VectorXcd far = Eigen::VectorXcd::Zero(root_.size());
  for (const SoftFace& face : farFaces_) {
    const Complex change = face.weight2 * (changeAt(field, face.face) / gauge - 1.0);
    for (const Term& t : face.similar) far[t.unknown] -= change * std::conj(t.factor) * face.fz;
    for (const Term& t : face.anti) far[t.unknown] -= change * std::conj(t.factor) * face.fzbar;
  }
  Eigen::VectorXcd reduced = root_.reduceLinear(far);
  return {cut, field, to, startOf(cut), std::move(far), std::move(reduced)};
}

/// Harmonic rows of the disc's inner vertices, from the corners as they now are.
/// @param soft  vertices whose rows need not hold exactly, besides the corners of soft triangles that are there whatever moves
void DragDisc::addRows(const DiscFrame& frame, const std::vector<VertexId>& soft,
                       SumOfSquares& sum) const {
  PerVertex<char> isSoft = isSoft_;
  for (VertexId v : soft) isSoft[v] = 1;
  for (VertexId v : near_) {
    if (ring_[v] == rings_ || !hasRow(v, frame.to)) continue;
    const Terms row = harmonicRow(mesh_, setup_.context->geometry, frame.cut, v);
    const double weight = rowWeight(v, isSoft[v] != 0) * portable::exp(-frame.field.scaleAt(v));
    sum.add(row, discAt_, valueOf(row, frame.start), weight * weight);
  }
}

/// Soft triangles within reach: of the cone where it now is, and those of others.
void DragDisc::addFaces(const DiscFrame& frame, const OwnFaces& own, SumOfSquares& sum) const {
  const Complex gauge = gaugeOf(frame.field);
  const auto addFace = [&](FaceId f, bool isOwn) {
    const SoftFace before = softFace(f);
    const FaceTerms terms = faceTerms(setup_.context->geometry, frame.cut, f);
    const Complex change = changeAt(frame.field, f) / gauge;
    const Complex target = isOwn ? targetAt(frame.field, f) : change * before.fz;
    const Complex targetBar = isOwn ? Complex(0.0) : change * before.fzbar;
    const double weight2 =
        before.weight2 * (isOwn ? own.weight : stiffness(before.fz, before.fzbar));
    sum.add(terms.similar, discAt_, valueOf(terms.similar, frame.start) - target, weight2);
    sum.add(terms.anti, discAt_, valueOf(terms.anti, frame.start) - targetBar, weight2);
  };
  for (FaceId f : own.faces) addFace(f, true);
  for (FaceId f : close_)
    if (!std::binary_search(own.faces.begin(), own.faces.end(), f)) addFace(f, false);
}

void DragDisc::addOutside(const DiscFrame& frame, SumOfSquares& sum) const {
  sum.H += outside_;
  for (Eigen::Index i = 0; i < sum.c.size(); ++i) sum.c[i] += frame.reduced[rootIndex(i)];
}

Eigen::VectorXcd DragDisc::solve(const DiscFrame& frame) const {
  const OwnFaces own{facesNear(frame.to)};
  std::vector<VertexId> soft;
  for (FaceId f : own.faces)
    for (VertexId v : mesh_.corners(f)) soft.push_back(v);
  SumOfSquares sum(disc_.size());
  addRows(frame, soft, sum);
  addFaces(frame, own, sum);
  addOutside(frame, sum);
  return FrameConditions(setup_.context->geometry, frame.cut, discAt_).minimise(sum);
}

Eigen::VectorXcd DragDisc::solveFramed(const DiscFrame& frame) const {
  OwnFaces own{{}, kTieBreak};
  for (HalfedgeId h : outgoingHalfedges(mesh_, frame.to)) own.faces.push_back(TriMesh::face(h));
  std::sort(own.faces.begin(), own.faces.end());
  SumOfSquares sum(disc_.size());
  addRows(frame, near_, sum);
  addFaces(frame, own, sum);
  addOutside(frame, sum);
  FrameConditions conditions(setup_.context->geometry, frame.cut, discAt_);
  for (FaceId f : own.faces) conditions.add(f, targetAt(frame.field, f), frame.start);
  return conditions.minimise(sum);
}

Eigen::VectorXcd DragDisc::changedInside(const DiscFrame& frame,
                                         const Eigen::VectorXcd& change) const {
  Eigen::VectorXcd x = frame.start;
  for (std::size_t i = 0; i < disc_.size(); ++i)
    x[disc_[i]] += change[static_cast<Eigen::Index>(i)];
  return x;
}

Eigen::VectorXcd DragDisc::changed(const DiscFrame& frame, const Eigen::VectorXcd& change) const {
  Eigen::VectorXd root(2 * change.size());
  for (Eigen::Index i = 0; i < change.size(); ++i)
    root.segment<2>(2 * rootIndex(i)) << change[i].real(), change[i].imag();
  const Eigen::VectorXcd all = root_.extend(root, frame.far);
  Eigen::VectorXcd kept = Eigen::VectorXcd::Zero(
      isSparse_ ? setup_.unknowns.count : static_cast<Eigen::Index>(kept_.size()));
  for (Eigen::Index i = 0; i < kept.size(); ++i) {
    const int index = index_[at(isSparse_ ? i : kept_[at(i)])];
    if (index >= 0) kept[i] = all[index];
  }
  return frame.start + (isSparse_ ? kept : Eigen::VectorXcd(lu_.extend(kept)));
}

}  // namespace hgp::live
