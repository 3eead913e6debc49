// One frame of a drag: the part of DragDisc that runs again for every position of the cone.
#include <algorithm>
#include <cmath>

#include "hgp/base/portable_math.h"
#include "hgp/optimize/frames.h"
#include "hgp/parametrize/live/drag_disc.h"
#include "hgp/socp/problem.h"
#include "hgp/system/weights.h"

namespace hgp::live {

namespace {

/// A Hermitian form as the real one that PartialCholesky takes.
Eigen::MatrixXd realForm(const Eigen::MatrixXcd& H) {
  Eigen::MatrixXd out(2 * H.rows(), 2 * H.rows());
  for (Eigen::Index j = 0; j < H.rows(); ++j)
    for (Eigen::Index i = 0; i < H.rows(); ++i) {
      const Complex h = H(i, j);
      out(2 * i, 2 * j) = out(2 * i + 1, 2 * j + 1) = h.real();
      out(2 * i + 1, 2 * j) = h.imag();
      out(2 * i, 2 * j + 1) = -h.imag();
    }
  return out;
}

}  // namespace

std::vector<HalfedgeId> DragDisc::pathTo(VertexId v) const {
  if (ring_[v] < 0 || ring_[v] > reach() || isFixed(v)) return {};
  // Breadth first from the cone, so that the same vertex always has the same path.
  std::vector<VertexId> queue{cone_};
  std::vector<std::pair<VertexId, HalfedgeId>> reached{{cone_, HalfedgeId()}};
  const auto find = [&](VertexId w) {
    return std::find_if(reached.begin(), reached.end(),
                        [&](const auto& r) { return r.first == w; });
  };
  for (std::size_t i = 0; i < queue.size() && find(v) == reached.end(); ++i)
    for (HalfedgeId h : outgoingHalfedges(mesh_, queue[i])) {
      const VertexId w = mesh_.head(h);
      if (isFixed(w) || ring_[w] < 0 || ring_[w] > reach() || find(w) != reached.end()) continue;
      reached.emplace_back(w, h);
      queue.push_back(w);
    }
  std::vector<HalfedgeId> path;
  if (find(v) == reached.end()) return path;
  for (VertexId w = v; w != cone_; w = mesh_.tail(path.back())) path.push_back(find(w)->second);
  std::reverse(path.begin(), path.end());
  return path;
}

std::vector<VertexId> DragDisc::towards(VertexId v) const {
  std::vector<VertexId> found;
  PerVertex<int> edges(mesh_.vertexCount(), -1);
  std::vector<VertexId> queue{v};
  edges[v] = 0;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const VertexId u = queue[i];
    if (edges[cone_] >= 0 && edges[u] >= edges[cone_]) break;
    if (!pathTo(u).empty()) found.push_back(u);
    for (HalfedgeId h : outgoingHalfedges(mesh_, u)) {
      const VertexId w = mesh_.head(h);
      if (edges[w] >= 0) continue;
      edges[w] = edges[u] + 1;
      queue.push_back(w);
    }
  }
  return found;
}

/// e^{Δu − iΔθ}: by how much the field turns and scales a triangle.
Complex DragDisc::changeAt(const MovedField& field, FaceId f) const {
  return portable::polar(portable::exp(field.scaleAt(f)), -field.angleAt(f));
}

/// The mean of these changes out of reach. Fields are defined up to a similarity; this one keeps the map in its place.
Complex DragDisc::gaugeOf(const MovedField& field) const {
  if (far_.empty()) return 1.0;
  double scale = 0.0;
  Complex turn = 0.0;
  for (FaceId f : far_) {
    scale += field.scaleAt(f);
    turn += portable::polar(1.0, -field.angleAt(f));
  }
  const double size = portable::abs(turn);
  const double mean = portable::exp(scale / static_cast<double>(far_.size()));
  return size > 0.0 ? mean * turn / size : Complex(mean);
}

Complex DragDisc::targetAt(const MovedField& field, FaceId f) const {
  const Complex frame = portable::polar(portable::exp(scaleAt(f)), -setup_.seams.frameAngle[f]);
  return changeAt(field, f) / gaugeOf(field) * scale_ * frame;
}

/// x*, numbered as `cut` does.
Eigen::VectorXcd DragDisc::startOf(const MovedCut& cut) const {
  Eigen::VectorXcd x = x_;
  if (cut.reusedUnknown() >= 0)
    x[cut.reusedUnknown()] = valueOf(still_.termsOf(cut.path().front()), x_);
  return x;
}

/// Harmonic rows of the disc's inner vertices, from the corners as they now are.
void DragDisc::addRows(const MovedCut& cut, const MovedField& field, VertexId to,
                       const Eigen::VectorXcd& x, SumOfSquares& sum) const {
  std::vector<VertexId> soft;
  for (FaceId f : facesNear(to))
    for (VertexId v : mesh_.corners(f)) soft.push_back(v);
  for (VertexId v : near_) {
    if (ring_[v] == rings_ || !hasRow(v, to)) continue;
    const Terms row = harmonicRow(mesh_, setup_.context->geometry, cut, v);
    const bool isSoft = isSoft_[v] != 0 || std::find(soft.begin(), soft.end(), v) != soft.end();
    const double weight = rowWeight(v, isSoft) * portable::exp(-field.scaleAt(v));
    sum.add(row, discAt_, valueOf(row, x), weight * weight);
  }
}

/// Soft triangles within reach: of the cone where it now is, and those of others.
void DragDisc::addFaces(const MovedCut& cut, const MovedField& field, VertexId to,
                        const Eigen::VectorXcd& x, SumOfSquares& sum) const {
  const std::vector<FaceId> own = facesNear(to);
  const Complex gauge = gaugeOf(field);
  const auto addFace = [&](FaceId f, bool isOwn) {
    const SoftFace before = softFace(f);
    const FaceTerms terms = faceTerms(setup_.context->geometry, cut, f);
    const Complex change = changeAt(field, f) / gauge;
    const Complex target = isOwn ? targetAt(field, f) : change * before.fz;
    const Complex targetBar = isOwn ? Complex(0.0) : change * before.fzbar;
    const double weight2 = before.weight2 * (isOwn ? 1.0 : stiffness(before.fz, before.fzbar));
    sum.add(terms.similar, discAt_, valueOf(terms.similar, x) - target, weight2);
    sum.add(terms.anti, discAt_, valueOf(terms.anti, x) - targetBar, weight2);
  };
  for (FaceId f : own) addFace(f, true);
  for (FaceId f : close_)
    if (!std::binary_search(own.begin(), own.end(), f)) addFace(f, false);
}

Eigen::VectorXcd DragDisc::solve(const MovedCut& cut, const MovedField& field, VertexId to) {
  if (cut.path().empty()) return x_;
  SumOfSquares sum(disc_.size());
  const Complex gauge = gaugeOf(field);
  Eigen::VectorXcd x = startOf(cut);
  addRows(cut, field, to, x, sum);
  addFaces(cut, field, to, x, sum);
  Eigen::VectorXcd c = Eigen::VectorXcd::Zero(root_.size());
  for (const SoftFace& face : farFaces_) {
    const Complex change = face.weight2 * (changeAt(field, face.face) / gauge - 1.0);
    for (const Term& t : face.similar) c[t.unknown] -= change * std::conj(t.factor) * face.fz;
    for (const Term& t : face.anti) c[t.unknown] -= change * std::conj(t.factor) * face.fzbar;
  }
  for (std::size_t i = 0; i < disc_.size(); ++i)
    c[index_[at(disc_[i])]] += sum.c[static_cast<Eigen::Index>(i)];
  if (!root_.factor({realForm(sum.H)})) return {};
  const Eigen::VectorXd rhs = -socp::reducedLinear(root_, c);
  const Eigen::VectorXcd delta = root_.extend(root_.solve(rhs), c);
  Eigen::VectorXcd moved = Eigen::VectorXcd::Zero(
      isSparse_ ? setup_.unknowns.count : static_cast<Eigen::Index>(kept_.size()));
  for (Eigen::Index i = 0; i < moved.size(); ++i) {
    const int index = index_[at(isSparse_ ? i : kept_[at(i)])];
    if (index >= 0) moved[i] = delta[index];
  }
  x += isSparse_ ? moved : Eigen::VectorXcd(lu_.extend(moved));
  return x;
}

}  // namespace hgp::live
