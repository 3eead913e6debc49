#include "hgp/quads/grid_lines.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "hgp/base/check.h"
#include "hgp/base/wide_integer.h"

namespace hgp {
namespace {

constexpr double kLargest = 0x1p55;

LatticePoint minus(const LatticePoint& a, const LatticePoint& b) { return {a.u - b.u, a.v - b.v}; }

Failure refusal(std::string message, std::vector<Where> where = {}) {
  return {ErrorCode::kUnsupported, "quads", std::move(message), std::move(where)};
}

/// The largest e ≤ 0 such that all coordinates are multiples of 2^e.
int commonExponent(const UvMap& map) {
  int lowest = 0;
  for (const auto& corners : map.cornerUv)
    for (int c : corners)
      for (double x : map.uv[at(c)]) {
        if (x == 0.0) continue;
        int exponent = 0;
        const double fraction = std::frexp(x, &exponent);
        const auto digits = static_cast<std::int64_t>(std::ldexp(fraction, 53));
        lowest =
            std::min(lowest, exponent - 53 + std::countr_zero(static_cast<std::uint64_t>(digits)));
      }
  return lowest;
}

}  // namespace

int crossSign(const LatticePoint& a, const LatticePoint& b) {
  return (WideInteger::product(a.u, b.v) - WideInteger::product(a.v, b.u)).sign();
}
int dotSign(const LatticePoint& a, const LatticePoint& b) {
  return (WideInteger::product(a.u, b.u) + WideInteger::product(a.v, b.v)).sign();
}

LatticePoint turned(const LatticePoint& p, int turn) {
  switch (turn & 3) {
    case 0:
      return p;
    case 1:
      return {-p.v, p.u};
    case 2:
      return {-p.u, -p.v};
    default:
      return {p.v, -p.u};
  }
}

int LatticeMap::side(HalfedgeId h, const LatticePoint& p) const {
  const LatticePoint& a = corner_[h];
  return crossSign(minus(corner_[TriMesh::next(h)], a), minus(p, a));
}

LatticePoint LatticeMap::step(int d) const { return turned({unit_, 0}, d); }

LatticePoint LatticeMap::across(HalfedgeId h, const LatticePoint& p) const {
  const LatticePoint q = turned(p, crossing_[h].turn);
  return {q.u + crossing_[h].shift.u, q.v + crossing_[h].shift.v};
}

Result<LatticeMap> LatticeMap::make(const TriMesh& mesh, const UvMap& map) {
  LatticeMap out;
  out.mesh_ = &mesh;
  const int exponent = commonExponent(map);
  double largest = 1.0;
  for (const auto& corners : map.cornerUv)
    for (int c : corners)
      for (double x : map.uv[at(c)]) largest = std::max(largest, std::fabs(x));
  if (!(std::ldexp(largest, -exponent) <= kLargest))
    return refusal("the map's coordinates share no grid: align it to a grid first");
  out.unit_ = std::int64_t{1} << -exponent;
  out.corner_ = PerHalfedge<LatticePoint>(at(mesh.halfedgeCount()));
  for (HalfedgeId h : mesh.halfedges()) {
    const Vec2& p = map.uv[at(map.cornerUv[at(h.i / 3)][at(h.i % 3)])];
    out.corner_[h] = {static_cast<std::int64_t>(std::ldexp(p[0], -exponent)),
                      static_cast<std::int64_t>(std::ldexp(p[1], -exponent))};
  }
  for (FaceId f : mesh.faces())
    if (out.side(TriMesh::halfedge(f, 0), out.corner_[TriMesh::halfedge(f, 2)]) <= 0)
      return refusal(formatText("triangle %d is not positive", f.i), {{Where::Kind::kFace, f.i}});
  out.crossing_ = PerHalfedge<Crossing>(at(mesh.halfedgeCount()));
  for (HalfedgeId h : mesh.halfedges()) {
    if (mesh.isBoundary(h)) continue;
    const HalfedgeId twin = mesh.twin(h);
    const LatticePoint here = minus(out.corner_[TriMesh::next(h)], out.corner_[h]);
    const LatticePoint there = minus(out.corner_[twin], out.corner_[TriMesh::next(twin)]);
    int turn = 0;
    while (turn < 4 && !(turned(here, turn) == there)) ++turn;
    const LatticePoint shift =
        minus(out.corner_[TriMesh::next(twin)], turned(out.corner_[h], turn));
    if (turn == 4 || !out.isWhole(shift))
      return refusal(
          formatText(
              "the grid does not continue across the edge %d–%d: its translation is not an integer",
              mesh.tail(h).i, mesh.head(h).i),
          {{Where::Kind::kEdge, mesh.tail(h).i, mesh.head(h).i}});
    out.crossing_[h] = {turn, shift};
  }
  return out;
}

}  // namespace hgp
