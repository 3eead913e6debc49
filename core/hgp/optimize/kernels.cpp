#include "hgp/optimize/kernels.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "hgp/base/portable_math.h"
#include "hgp/mesh/face_rings.h"

namespace hgp {
namespace {

/// With more flipped triangles than this nothing is done, nor at vertices of more triangles.
constexpr int kMaxFlipped = 32;
constexpr int kLargestRing = 24;
/// Passes over the vertices of flipped triangles and their neighbours.
constexpr int kPasses = 40;
/// A vertex moves if its depth grows by this share of its amount.
constexpr double kGain = 1e-3;

/// Signed distance from an edge of the ring, d + Re(n̄ δ), where the vertex has moved by δ.
struct HalfPlane {
  Complex n;
  double d;
};

double depthAt(const std::vector<HalfPlane>& ring, Complex move) {
  double depth = std::numeric_limits<double>::infinity();
  for (const HalfPlane& side : ring)
    depth = std::min(depth, side.d + std::real(std::conj(side.n) * move));
  return depth;
}

/// The δ that is deepest in all half-planes; 0 where there is no deepest.
Complex deepest(const std::vector<HalfPlane>& ring) {
  Complex best = 0.0;
  double bestDepth = depthAt(ring, best);
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j)
      for (std::size_t k = j + 1; k < n; ++k) {
        Eigen::Matrix3d A;
        Eigen::Vector3d b;
        Eigen::Index row = 0;
        for (const std::size_t side : {i, j, k}) {
          A.row(row) << ring[side].n.real(), ring[side].n.imag(), -1.0;
          b[row++] = -ring[side].d;
        }
        const double determinant = A.determinant();
        if (!(std::abs(determinant) > 1e-14)) continue;
        const Eigen::Vector3d at = A.inverse() * b;
        const Complex move(at[0], at[1]);
        const double depth = depthAt(ring, move);
        if (depth > bestDepth) bestDepth = depth, best = move;
      }
  return best;
}

class Kernels {
 public:
  Kernels(const SeamlessSystem& system, Eigen::VectorXcd& x) : system_(system), x_(x) {
    z_ = system.unknowns.copies * x;
  }

  int run() {
    std::vector<FaceId> flipped = findFlipped();
    for (int pass = 0; pass < kPasses && !flipped.empty(); ++pass) {
      if (static_cast<int>(flipped.size()) > kMaxFlipped) break;
      bool isMoved = false;
      for (VertexId v : verticesNear(flipped, pass % 2 == 1)) isMoved = move(v) || isMoved;
      flipped = findFlipped();
      if (!isMoved && pass % 2 == 1) break;
    }
    return static_cast<int>(flipped.size());
  }

 private:
  Complex& at(HalfedgeId h) { return z_[system_.cut.copy[h].i]; }

  double doubleArea(HalfedgeId h) {
    const Complex a = at(h), b = at(TriMesh::next(h)), c = at(TriMesh::previous(h));
    return std::imag(std::conj(b - a) * (c - a));
  }

  std::vector<FaceId> findFlipped() {
    std::vector<FaceId> out;
    for (FaceId f : system_.mesh.faces())
      if (!(doubleArea(TriMesh::halfedge(f, 0)) > 0.0)) out.push_back(f);
    return out;
  }

  std::vector<VertexId> verticesNear(const std::vector<FaceId>& faces, bool isWide) const {
    std::vector<VertexId> out;
    for (FaceId f : isWide ? growFaces(system_.mesh, faces, 1) : faces)
      for (VertexId v : system_.mesh.corners(f)) out.push_back(v);
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
  }

  /// Whether v moved.
  bool move(VertexId v) {
    const int unknown = system_.unknowns.vertexUnknown[v];
    if (unknown < 0 || system_.mesh.isBoundary(v)) return false;
    ring_.clear();
    for (HalfedgeId h : outgoingHalfedges(system_.mesh, v)) {
      // Copy s is the first one turned by R and moved, so that edges are turned back by R.
      const Complex R = system_.unknowns.copies.coeff(system_.cut.copy[h].i, unknown);
      const Complex edge = at(TriMesh::previous(h)) - at(TriMesh::next(h));
      const double length = portable::abs(edge);
      if (!(length > 0.0)) return false;
      ring_.push_back({std::conj(R) * edge * Complex(0.0, 1.0) / length, doubleArea(h) / length});
    }
    if (ring_.size() > kLargestRing) return false;
    const double before = depthAt(ring_, 0.0);
    const Complex step = deepest(ring_);
    const double after = depthAt(ring_, step);
    const bool isWrong = !(before > 0.0);
    if (!isWrong || !(after > before + kGain * std::abs(before))) return false;
    x_[unknown] += step;
    for (HalfedgeId h : outgoingHalfedges(system_.mesh, v)) {
      const int copy = system_.cut.copy[h].i;
      z_[copy] = std::conj(system_.unknowns.copies.row(copy).dot(x_.conjugate()));
    }
    return true;
  }

  const SeamlessSystem& system_;
  Eigen::VectorXcd& x_;
  Eigen::VectorXcd z_;
  std::vector<HalfPlane> ring_;
};

}  // namespace

void moveIntoKernels(const SeamlessSystem& system, UntangleResult& result) {
  Eigen::VectorXcd x = result.x;
  if (Kernels(system, x).run() > 0) return;
  result.x = std::move(x);
  result.flipped = 0;
}

}  // namespace hgp
