#include "hgp/parametrize/live/mend.h"

#include <Eigen/Dense>
#include <algorithm>

#include "hgp/base/portable_math.h"

namespace hgp::live {
namespace {

constexpr int kMendedRings = 2;
/// Weight of a triangle's distortion relative to the harmonic rows: of changes, and of reversed ones, which grows.
constexpr double kChange = 0.03;
constexpr double kFirst = 0.3;
constexpr double kGrowth = 8.0;
constexpr int kAttempts = 5;

double faceScale(const Mending& on, FaceId f) {
  double u = 0.0;
  for (VertexId v : on.mesh.corners(f)) u += on.scale(v) / 3.0;
  return u;
}

class Patch {
 public:
  Patch(const Mending& on, const std::vector<FaceId>& reversed) : on_(on) {
    std::vector<VertexId> near;
    for (FaceId f : reversed)
      for (VertexId v : on.mesh.corners(f)) include(near, v);
    for (int ring = 0; ring < kMendedRings; ++ring) grow(near);
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

  /// One step from x, with this weight on the triangles in `reversed`, ascending.
  void step(const std::vector<FaceId>& reversed, double weight, Eigen::VectorXcd& x) const {
    SumOfSquares sum(unknowns_.size());
    for (VertexId v : rows_) {
      if (!on_.hasRow(v)) continue;
      const Terms row = harmonicRow(on_.mesh, on_.setup.context->geometry, on_.cut, v);
      sum.add(row, index_, valueOf(row, x), portable::exp(-2.0 * on_.scale(v)));
    }
    for (FaceId f : faces_) {
      const FaceTerms terms = faceTerms(on_.setup.context->geometry, on_.cut, f);
      const double unit =
          on_.setup.context->geometry.area[f] * portable::exp(-2.0 * faceScale(on_, f));
      const Complex fz = valueOf(terms.similar, x), fzbar = valueOf(terms.anti, x);
      const bool isReversed = std::binary_search(reversed.begin(), reversed.end(), f);
      const double weight2 = unit * (isReversed ? weight : kChange * stiffness(fz, fzbar));
      sum.add(terms.similar, index_, isReversed ? fz - on_.target(f) : Complex(0.0), weight2);
      sum.add(terms.anti, index_, isReversed ? fzbar : Complex(0.0), weight2);
    }
    const Eigen::VectorXcd delta = sum.H.ldlt().solve(-sum.c);
    if (!delta.allFinite()) return;
    for (std::size_t i = 0; i < unknowns_.size(); ++i)
      x[unknowns_[i]] += delta[static_cast<Eigen::Index>(i)];
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

}  // namespace

std::vector<FaceId> reversedFaces(const Mending& on, const Eigen::VectorXcd& x) {
  Eigen::VectorXcd z(on.cut.uvCount());
  z.head(on.setup.unknowns.copies.rows()) = on.setup.unknowns.copies * x;
  for (const MovedCut::Copy& copy : on.cut.copies()) z[copy.uv] = valueOf(copy.position, x);
  std::vector<FaceId> reversed;
  for (FaceId f : on.mesh.faces()) {
    const auto corner = [&](int k) { return z[on.cut.uvOf(TriMesh::halfedge(f, k))]; };
    const Complex a = corner(0);
    if (!(std::imag(std::conj(corner(1) - a) * (corner(2) - a)) > 0.0)) reversed.push_back(f);
  }
  return reversed;
}

bool mend(const Mending& on, Eigen::VectorXcd& x) {
  std::vector<FaceId> reversed = reversedFaces(on, x), asked = reversed;
  if (reversed.empty()) return true;
  Eigen::VectorXcd best = x;
  std::size_t fewest = reversed.size();
  double weight = kFirst;
  for (int attempt = 0; attempt < kAttempts && asked.size() <= kMaxMended; ++attempt) {
    Patch(on, asked).step(asked, weight, x);
    reversed = reversedFaces(on, x);
    if (reversed.size() < fewest) {
      fewest = reversed.size();
      best = x;
    }
    if (reversed.empty()) return true;
    asked.insert(asked.end(), reversed.begin(), reversed.end());
    std::sort(asked.begin(), asked.end());
    asked.erase(std::unique(asked.begin(), asked.end()), asked.end());
    weight *= kGrowth;
  }
  x = best;
  return false;
}

}  // namespace hgp::live
