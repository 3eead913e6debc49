#include "hgp/quads/grid_walk.h"

#include <utility>

namespace hgp {
namespace {

LatticePoint vectorOf(const LatticeMap& map, HalfedgeId h) {
  const LatticePoint &a = map.corner(h), &b = map.corner(TriMesh::next(h));
  return {b.u - a.u, b.v - a.v};
}
LatticePoint negative(const LatticePoint& p) { return {-p.u, -p.v}; }

bool isBetween(const LatticePoint& start, const LatticePoint& d, const LatticePoint& end) {
  const int fromStart = crossSign(start, d), toEnd = crossSign(d, end);
  const bool isAlongStart = fromStart == 0 && dotSign(start, d) > 0;
  if (crossSign(start, end) == 0) return isAlongStart || fromStart > 0;  // half a turn
  return (isAlongStart || fromStart > 0) && toEnd > 0;
}

bool isLeft(const LatticePoint& p, const LatticePoint& step, const LatticePoint& c) {
  return crossSign(step, {c.u - p.u, c.v - p.v}) > 0;
}

void append(const LatticeMap& map, FaceId f, const LatticePoint& p, const LatticePoint& start,
            const LatticePoint& end, GridRing& ring) {
  for (const int d : directionsBetween(map, start, end))
    if (d >= 0) ring.rays.push_back({f, p, d});
}

}  // namespace

GridPlace placeIn(const LatticeMap& map, FaceId f, const LatticePoint& p) {
  for (int k = 0; k < 3; ++k) {
    const HalfedgeId h = TriMesh::halfedge(f, k);
    if (map.corner(h) == p) return {GridPlace::Kind::kVertex, h};
  }
  for (int k = 0; k < 3; ++k) {
    const HalfedgeId h = TriMesh::halfedge(f, k);
    if (map.side(h, p) == 0) return {GridPlace::Kind::kEdge, h};
  }
  return {};
}

GridKey keyOf(const LatticeMap& map, FaceId f, const LatticePoint& p) {
  const TriMesh& mesh = map.mesh();
  const auto [kind, on] = placeIn(map, f, p);
  if (kind == GridPlace::Kind::kFace) return {kind, f.i, p.u, p.v};
  if (kind == GridPlace::Kind::kVertex) return {kind, mesh.tail(on).i, 0, 0};
  const EdgeId e = mesh.edge(on);
  const LatticePoint here = mesh.halfedge(e) == on ? p : map.across(on, p);
  return {kind, e.i, here.u, here.v};
}

std::array<int, 2> directionsBetween(const LatticeMap& map, const LatticePoint& start,
                                     const LatticePoint& end) {
  // At most two grid directions lie in a half-open range of at most half a turn.
  std::array<int, 2> out{-1, -1};
  for (int d = 0; d < 4; ++d) {
    if (!isBetween(start, map.step(d), end)) continue;
    (out[0] < 0 ? out[0] : out[1]) = d;
  }
  if (out[1] >= 0 && crossSign(map.step(out[0]), map.step(out[1])) < 0) std::swap(out[0], out[1]);
  return out;
}

std::optional<GridRay> walkTo(const LatticeMap& map, FaceId f, LatticePoint q, int direction) {
  for (;;) {
    bool isHere = true;
    for (int k = 0; k < 3 && isHere; ++k) isHere = map.side(TriMesh::halfedge(f, k), q) >= 0;
    if (isHere) return GridRay{f, q, (direction + 2) & 3};
    const LatticePoint step = map.step(direction);
    HalfedgeId exit;
    for (int k = 0; k < 3; ++k) {
      const HalfedgeId h = TriMesh::halfedge(f, k);
      if (!isLeft(q, step, map.corner(h)) && isLeft(q, step, map.corner(TriMesh::next(h))))
        exit = h;
    }
    if (!exit.isValid() || map.mesh().isBoundary(exit)) return {};
    q = map.across(exit, q);
    direction = map.directionAcross(exit, direction);
    f = TriMesh::face(map.mesh().twin(exit));
  }
}

GridArrival arrivalOf(const LatticeMap& map, const GridRay& end, const GridPlace& place) {
  if (!place.on.isValid()) return {end};
  const bool isVertex = place.kind == GridPlace::Kind::kVertex;
  const HalfedgeId over = isVertex ? TriMesh::previous(place.on) : place.on;
  const LatticePoint last = negative(vectorOf(map, over)), step = map.step(end.direction);
  if (crossSign(step, last) != 0 || dotSign(step, last) < 0) return {end};
  if (map.mesh().isBoundary(over)) return {end, true};
  return {{TriMesh::face(map.mesh().twin(over)), map.across(over, end.at),
           map.directionAcross(over, end.direction)}};
}

GridRing ringAt(const LatticeMap& map, FaceId f, const LatticePoint& p) {
  const TriMesh& mesh = map.mesh();
  const auto [kind, on] = placeIn(map, f, p);
  GridRing ring;
  if (kind == GridPlace::Kind::kFace) {
    for (int d = 0; d < 4; ++d) ring.rays.push_back({f, p, d});
    return ring;
  }
  if (kind == GridPlace::Kind::kEdge) {
    append(map, f, p, vectorOf(map, on), negative(vectorOf(map, on)), ring);
    ring.isClosed = !mesh.isBoundary(on);
    if (!ring.isClosed) return ring;
    const HalfedgeId twin = mesh.twin(on);
    append(map, TriMesh::face(twin), map.across(on, p), vectorOf(map, twin),
           negative(vectorOf(map, twin)), ring);
    return ring;
  }
  const VertexId v = mesh.tail(on);
  ring.isClosed = !mesh.isBoundary(v);
  for (HalfedgeId h : outgoingHalfedges(mesh, v))
    append(map, TriMesh::face(h), map.corner(h), vectorOf(map, h),
           negative(vectorOf(map, TriMesh::previous(h))), ring);
  return ring;
}

}  // namespace hgp
