#include "hgp/quads/near_seams.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "hgp/quads/grid_walk.h"

namespace hgp {
namespace {

class NearSeams {
 public:
  explicit NearSeams(const LatticeMap& map) : map_(map), mesh_(map.mesh()) {}

  bool search(const PerEdge<char>& isSeam) {
    collect(isSeam);
    // The edges along a boundary have a ray at one end only.
    bool hasBoundary = false;
    for (EdgeId e : mesh_.edges()) hasBoundary = hasBoundary || mesh_.isBoundary(mesh_.halfedge(e));
    const std::map<GridKey, Spot> spots = spots_;
    for (const auto& [key, spot] : spots) {
      if (hasPair(key, spot)) return true;
      if (!hasBoundary) continue;
      for (const GridRay& ray : ringAt(map_, spot.face, spot.at).rays)
        if (const auto end = endOf(ray))
          if (hasPair(keyOf(map_, end->face, end->at), {end->face, end->at})) return true;
    }
    return false;
  }

 private:
  struct Spot {
    FaceId face;
    LatticePoint at;
  };
  void add(FaceId f, const LatticePoint& p) { spots_.emplace(keyOf(map_, f, p), Spot{f, p}); }

  /// The grid points on seams, and the ends of the grid edges across seams.
  void collect(const PerEdge<char>& isSeam) {
    for (EdgeId e : mesh_.edges()) {
      if (!isSeam[e] || mesh_.isBoundary(mesh_.halfedge(e))) continue;
      const HalfedgeId one = mesh_.halfedge(e);
      for (const HalfedgeId h : {one, mesh_.twin(one)}) {
        if (map_.isWhole(map_.corner(h))) add(TriMesh::face(h), map_.corner(h));
        for (int d = 0; d < 4; ++d) cross(h, d);
      }
    }
  }

  /// The grid edges in direction d that leave the face through h: their ends, which may lie on h.
  void cross(HalfedgeId h, int d) {
    const std::int64_t one = map_.unit();
    // In a plane in which d is the u axis.
    const LatticePoint a = turned(map_.corner(h), -d),
                       b = turned(map_.corner(TriMesh::next(h)), -d);
    for (std::int64_t row = ceilDiv(a.v, one); row * one < b.v; ++row) {
      const double share = static_cast<double>(row * one - a.v) / static_cast<double>(b.v - a.v);
      const double u = static_cast<double>(a.u) + share * static_cast<double>(b.u - a.u);
      // The exact test moves the rounded start to the first point that is not left of h.
      auto column = static_cast<std::int64_t>(std::floor(u / static_cast<double>(one))) - 1;
      LatticePoint q = turned({column * one, row * one}, d);
      while (map_.side(h, q) > 0) q = turned({++column * one, row * one}, d);
      const HalfedgeId twin = mesh_.twin(h);
      const auto end =
          walkTo(map_, TriMesh::face(twin), map_.across(h, q), map_.directionAcross(h, d));
      if (end) add(end->face, end->at);
    }
  }
  static std::int64_t ceilDiv(std::int64_t a, std::int64_t b) {
    return a >= 0 ? (a + b - 1) / b : -(-a / b);
  }

  std::optional<GridRay> endOf(const GridRay& ray) const {
    const LatticePoint step = map_.step(ray.direction);
    return walkTo(map_, ray.face, {ray.at.u + step.u, ray.at.v + step.v}, ray.direction);
  }

  /// The edge after `ray` around the cell on its left.
  std::optional<GridRay> nextAround(const GridRay& ray) const {
    const std::optional<GridRay> end = endOf(ray);
    if (!end) return {};
    const GridArrival back = arrivalOf(map_, *end, placeIn(map_, end->face, end->at));
    const GridRing ring = ringAt(map_, end->face, end->at);
    if (ring.rays.empty()) return {};
    if (back.alongBoundary) return ring.rays.back();
    const auto found = std::find(ring.rays.begin(), ring.rays.end(), back.ray);
    if (found == ring.rays.end()) return {};
    if (found != ring.rays.begin()) return *(found - 1);
    if (!ring.isClosed) return {};
    return ring.rays.back();
  }

  /// The corners of the cell on the left of `ray`, from its start; nothing where the boundary cuts it.
  std::optional<std::array<GridKey, 4>> cellOf(const GridRay& ray) const {
    std::array<GridKey, 4> out;
    GridRay at = ray;
    for (GridKey& key : out) {
      key = keyOf(map_, at.face, at.at);
      const std::optional<GridRay> next = nextAround(at);
      if (!next) return {};
      at = *next;
    }
    if (!(at == ray)) return {};
    return out;
  }

  bool hasPair(const GridKey& key, const Spot& spot) {
    if (!isSeen_.insert(key).second) return false;
    std::set<GridKey> ends;
    for (const GridRay& ray : ringAt(map_, spot.face, spot.at).rays) {
      const std::optional<std::array<GridKey, 4>> cell = cellOf(ray);
      if (!cell) continue;
      const bool isNew = ends.insert((*cell)[1]).second;
      if ((*cell)[1] == key || (!isNew && !isFolded(spot, key, (*cell)[1]))) return true;
    }
    return false;
  }

  /// Whether a and b are the ends of two edges of a quad around a cone of k = 1, which coincide in any grid.
  bool isFolded(const Spot& a, const GridKey& keyA, const GridKey& keyB) const {
    const GridRing ring = ringAt(map_, a.face, a.at);
    return std::any_of(ring.rays.begin(), ring.rays.end(), [&](const GridRay& ray) {
      const std::optional<GridRay> end = endOf(ray);
      if (!end) return false;
      // The cone is a neighbour of a, or of b with the cell between.
      return isTip(*end, keyA, keyB) || isNextToTip(*end, keyA, keyB);
    });
  }
  bool isTip(const GridRay& end, const GridKey& a, const GridKey& b) const {
    const GridRing ring = ringAt(map_, end.face, end.at);
    if (ring.rays.size() != 1 || !ring.isClosed) return false;
    const std::optional<std::array<GridKey, 4>> cell = cellOf(ring.rays[0]);
    return cell && (*cell)[1] == (*cell)[3] &&
           (((*cell)[1] == a && (*cell)[2] == b) || ((*cell)[1] == b && (*cell)[2] == a));
  }
  bool isNextToTip(const GridRay& end, const GridKey& a, const GridKey& b) const {
    if (!(keyOf(map_, end.face, end.at) == b)) return false;
    const GridRing ring = ringAt(map_, end.face, end.at);
    return std::any_of(ring.rays.begin(), ring.rays.end(), [&](const GridRay& ray) {
      const std::optional<GridRay> tip = endOf(ray);
      return tip && isTip(*tip, a, b);
    });
  }

  const LatticeMap& map_;
  const TriMesh& mesh_;
  std::map<GridKey, Spot> spots_;
  std::set<GridKey> isSeen_;
};

}  // namespace

bool hasMultipleEdges(const TriMesh& mesh, const UvMap& map, const PerEdge<char>& isSeam) {
  const Result<LatticeMap> lattice = LatticeMap::make(mesh, map);
  return lattice && NearSeams(*lattice).search(isSeam);
}

}  // namespace hgp
