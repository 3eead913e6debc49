#include "hgp/parametrize/live/mend.h"

#include <algorithm>

#include "hgp/base/portable_math.h"
#include "hgp/parametrize/live/frame_conditions.h"

namespace hgp::live {
namespace {

constexpr int kMendedRings = 2;  ///< around wrong triangles; one more with each attempt
constexpr int kAttempts = 4;
constexpr std::size_t kMaxMended = 80;  ///< triangles
/// Weight of a triangle's distortion relative to the harmonic rows.
constexpr double kChange = 0.03;

double faceScale(const Mending& on, FaceId f) {
  double u = 0.0;
  for (VertexId v : on.mesh.corners(f)) u += on.scale(v) / 3.0;
  return u;
}

class Patch {
 public:
  Patch(const Mending& on, const std::vector<FaceId>& framed, int rings) : on_(on) {
    std::vector<VertexId> near;
    for (FaceId f : framed)
      for (VertexId v : on.mesh.corners(f)) include(near, v);
    for (int ring = 0; ring < rings; ++ring) grow(near);
    index_.assign(at(on.setup.unknowns.count), -1);
    for (VertexId v : near) {
      const int unknown = on.unknownOf(v);
      if (unknown < 0) continue;
      index_[at(unknown)] = static_cast<int>(unknowns_.size());
      unknowns_.push_back(unknown);
    }
    grow(near);
    rows_ = near;
    for (VertexId v : near)
      for (HalfedgeId h : outgoingHalfedges(on.mesh, v)) faces_.push_back(TriMesh::face(h));
    std::sort(faces_.begin(), faces_.end());
    faces_.erase(std::unique(faces_.begin(), faces_.end()), faces_.end());
  }

  /// The minimiser from x with frame conditions on these triangles, ascending; false where there is none.
  bool solve(const std::vector<FaceId>& framed, Eigen::VectorXcd& x) const {
    const Geometry& geometry = on_.setup.context->geometry;
    SumOfSquares sum(unknowns_.size());
    for (VertexId v : rows_) {
      if (!on_.hasRow(v)) continue;
      const Terms row = harmonicRow(on_.mesh, geometry, on_.cut, v);
      sum.add(row, index_, valueOf(row, x), portable::exp(-2.0 * on_.scale(v)));
    }
    FrameConditions conditions(geometry, on_.cut, index_);
    for (FaceId f : faces_) {
      const FaceTerms terms = faceTerms(geometry, on_.cut, f);
      const double weight2 = kChange * geometry.area[f] * portable::exp(-2.0 * faceScale(on_, f));
      const Complex fz = valueOf(terms.similar, x), fzbar = valueOf(terms.anti, x);
      const bool isFramed = std::binary_search(framed.begin(), framed.end(), f);
      const double stiff = isFramed ? 1.0 : stiffness(fz, fzbar);
      sum.add(terms.similar, index_, isFramed ? fz - on_.target(f) : Complex(0.0), weight2 * stiff);
      sum.add(terms.anti, index_, isFramed ? fzbar : Complex(0.0), weight2 * stiff);
      if (isFramed) conditions.add(f, on_.target(f), x);
    }
    const Eigen::VectorXcd delta = conditions.minimise(sum);
    if (delta.size() == 0 || !delta.allFinite()) return false;
    for (std::size_t i = 0; i < unknowns_.size(); ++i)
      x[unknowns_[i]] += delta[static_cast<Eigen::Index>(i)];
    return true;
  }

 private:
  static void include(std::vector<VertexId>& list, VertexId v) {
    if (std::find(list.begin(), list.end(), v) == list.end()) list.push_back(v);
  }
  void grow(std::vector<VertexId>& list) const {
    const std::vector<VertexId> inner = list;
    for (VertexId v : inner)
      for (HalfedgeId h : outgoingHalfedges(on_.mesh, v)) {
        include(list, on_.mesh.head(h));
        include(list, on_.mesh.tail(TriMesh::previous(h)));
      }
  }

  const Mending& on_;
  std::vector<int> unknowns_, index_;
  std::vector<VertexId> rows_;
  std::vector<FaceId> faces_;
};

void include(const std::vector<FaceId>& faces, std::vector<FaceId>& in) {
  in.insert(in.end(), faces.begin(), faces.end());
  std::sort(in.begin(), in.end());
  in.erase(std::unique(in.begin(), in.end()), in.end());
}

template <class PositionAt>
bool isPositive(FaceId f, const PositionAt& positionAt) {
  const Complex a = positionAt(TriMesh::halfedge(f, 0));
  const Complex b = positionAt(TriMesh::halfedge(f, 1));
  const Complex c = positionAt(TriMesh::halfedge(f, 2));
  return std::imag(std::conj(b - a) * (c - a)) > 0.0;
}

/// Triangles around the cone if the map does not turn around it as often as it should.
std::vector<FaceId> wrongRing(const Mending& on, const Eigen::VectorXcd& x) {
  std::vector<FaceId> ring;
  double angle = 0.0;
  for (HalfedgeId h : outgoingHalfedges(on.mesh, on.cone)) {
    const Complex centre = valueOf(on.cut.termsOf(h), x);
    const Complex a = valueOf(on.cut.termsOf(TriMesh::next(h)), x) - centre;
    const Complex b = valueOf(on.cut.termsOf(TriMesh::previous(h)), x) - centre;
    angle += portable::arg(b * std::conj(a));
    ring.push_back(TriMesh::face(h));
  }
  if (std::abs(angle - on.angle) < kPi / on.cut.q()) ring.clear();
  return ring;
}

}  // namespace

std::vector<FaceId> wrongFaces(const Mending& on, const Eigen::VectorXcd& x) {
  Eigen::VectorXcd z(on.cut.uvCount());
  z.head(on.setup.unknowns.copies.rows()) = on.setup.unknowns.copies * x;
  for (const MovedCut::Copy& copy : on.cut.copies()) z[copy.uv] = valueOf(copy.position, x);
  std::vector<FaceId> wrong;
  for (FaceId f : on.mesh.faces())
    if (!isPositive(f, [&](HalfedgeId h) { return z[on.cut.uvOf(h)]; })) wrong.push_back(f);
  include(wrongRing(on, x), wrong);
  return wrong;
}

std::vector<FaceId> wrongAmong(const Mending& on, const std::vector<FaceId>& faces,
                               const Eigen::VectorXcd& x) {
  std::vector<FaceId> wrong;
  for (FaceId f : faces)
    if (!isPositive(f, [&](HalfedgeId h) { return valueOf(on.cut.termsOf(h), x); }))
      wrong.push_back(f);
  include(wrongRing(on, x), wrong);
  return wrong;
}

bool mend(const Mending& on, Eigen::VectorXcd& x) {
  const Eigen::VectorXcd start = x;
  std::vector<FaceId> framed = wrongFaces(on, x);
  std::size_t fewest = framed.size();
  for (int attempt = 0; fewest > 0 && attempt < kAttempts && framed.size() <= kMaxMended;
       ++attempt) {
    Eigen::VectorXcd tried = start;
    if (!Patch(on, framed, kMendedRings + attempt).solve(framed, tried)) continue;
    const std::vector<FaceId> wrong = wrongFaces(on, tried);
    include(wrong, framed);
    if (wrong.size() >= fewest) continue;
    fewest = wrong.size();
    x = std::move(tried);
  }
  return fewest == 0;
}

}  // namespace hgp::live
