#include "hgp/grid/positive_repair.h"

#include <algorithm>

#include "hgp/grid/lattice.h"

namespace hgp {
namespace {

constexpr int kPasses = 12;  ///< over the triangles that rounding flipped

template <class Ring>
WideInteger doubleArea(Ring a, Ring b, Ring c) {
  using L = Lattice<Ring>;
  const Ring ab = b - a, ac = c - a;
  return WideInteger::product(L::x(ab), L::y(ac)) - WideInteger::product(L::y(ab), L::x(ac));
}

}  // namespace

template <class Ring>
int PositiveRepair<Ring>::run(std::vector<FaceId>& broken) {
  std::vector<char> isMoved(at(mesh_.vertexCount()), 0);
  for (int pass = 0; pass < kPasses && !broken.empty(); ++pass) {
    const std::int64_t reach = pass < kPasses / 2 ? 1 : 4;
    bool isAny = false;
    for (FaceId f : broken)
      for (VertexId v : mesh_.corners(f)) {
        if (closureOf_[v] >= 0 || (straight_ && straight_->isTied(v)) || !move(v, reach)) continue;
        isMoved[at(v.i)] = 1;
        isAny = true;
      }
    std::erase_if(broken, [&](FaceId f) { return isPositive(f); });
    if (!isAny && reach > 1) break;
  }
  return static_cast<int>(std::count(isMoved.begin(), isMoved.end(), 1));
}

template <class Ring>
WideInteger PositiveRepair<Ring>::area(FaceId f, VertexId v, Ring d) const {
  Ring p[3];
  for (int k = 0; k < 3; ++k) {
    const HalfedgeId h = TriMesh::halfedge(f, k);
    const int c = seams_.copy[h];
    p[k] = points_[at(c)];
    if (mesh_.tail(h) == v) p[k] = p[k] + Ring::turned(seams_.place(c).turn) * d;
  }
  return doubleArea(p[0], p[1], p[2]);
}

template <class Ring>
WideInteger PositiveRepair<Ring>::smallestArea(VertexId v, Ring d) const {
  WideInteger smallest;
  bool isFirst = true;
  for (HalfedgeId h : outgoingHalfedges(mesh_, v)) {
    const WideInteger a = area(TriMesh::face(h), v, d);
    if (isFirst || a < smallest) smallest = a;
    isFirst = false;
  }
  return smallest;
}

template <class Ring>
bool PositiveRepair<Ring>::move(VertexId v, std::int64_t reach) {
  Ring best;
  WideInteger bestArea = smallestArea(v, best);
  for (std::int64_t dx = -2; dx <= 2; ++dx)
    for (std::int64_t dy = -2; dy <= 2; ++dy) {
      const Ring d = Lattice<Ring>::point(dx * reach, dy * reach);
      const WideInteger candidate = smallestArea(v, d);
      if (candidate <= bestArea) continue;
      bestArea = candidate;
      best = d;
    }
  if (isZero(best)) return false;
  std::vector<int> done;
  for (HalfedgeId h : outgoingHalfedges(mesh_, v)) {
    const int c = seams_.copy[h];
    if (std::find(done.begin(), done.end(), c) != done.end()) continue;
    done.push_back(c);
    points_[at(c)] = points_[at(c)] + Ring::turned(seams_.place(c).turn) * best;
  }
  return true;
}

template class PositiveRepair<Gaussian>;
template class PositiveRepair<Eisenstein>;

}  // namespace hgp
