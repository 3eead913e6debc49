#include "hgp/quads/corner_places.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hgp/base/check.h"
#include "hgp/mesh/barycentric.h"

namespace hgp {
namespace {

/// A smaller weight counts as none.
constexpr double kOnSide = 1e-9;
/// Faces near a side are those that meet the ball around it, this much larger than the smallest one …
constexpr double kBall = 1.1;
/// … and twice as large as often, until they connect its ends.
constexpr int kBalls = 4;

std::array<Vec3, 3> positionsOf(const TriMesh& mesh, FaceId f) {
  const auto [i, j, k] = mesh.corners(f);
  return {mesh.position(i), mesh.position(j), mesh.position(k)};
}

std::size_t cornerOf(HalfedgeId h) { return static_cast<std::size_t>(h.i % 3); }

/// The point of a segment nearest to p, as a share of the way from a to b.
double shareNear(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 side = subtract(b, a);
  const double square = dot(side, side);
  return square > 0.0 ? std::clamp(dot(subtract(p, a), side) / square, 0.0, 1.0) : 0.0;
}

/// Of p from a segment.
double distanceTo(const Vec3& p, const Vec3& a, const Vec3& b) {
  return distance(p, add(a, scaled(subtract(b, a), shareNear(p, a, b))));
}

/// The point of halfedge h nearest to p, as a point of its face.
CornerPlace placeOn(const TriMesh& mesh, HalfedgeId h, const Vec3& p) {
  const bool isUp = mesh.tail(h) < mesh.head(h);
  const double share = shareNear(p, mesh.position(isUp ? mesh.tail(h) : mesh.head(h)),
                                 mesh.position(isUp ? mesh.head(h) : mesh.tail(h)));
  CornerPlace out{TriMesh::face(h), {}};
  out.weight[cornerOf(isUp ? h : TriMesh::next(h))] = 1.0 - share;
  out.weight[cornerOf(isUp ? TriMesh::next(h) : h)] = share;
  return out;
}

Vec3 unitOf(const Vec3& a) {
  const double length = norm(a);
  return length > 0.0 ? scaled(a, 1.0 / length) : a;
}

/// How far `way` leads from halfedge h into its face, in the plane of which it is seen.
double inwardOf(const TriMesh& mesh, HalfedgeId h, const Vec3& way) {
  const Vec3 side = unitOf(subtract(mesh.position(mesh.head(h)), mesh.position(mesh.tail(h))));
  Vec3 inward =
      subtract(mesh.position(mesh.tail(TriMesh::previous(h))), mesh.position(mesh.tail(h)));
  inward = unitOf(subtract(inward, scaled(side, dot(inward, side))));
  return dot(way, inward);
}

/// How far `way`, from the tail of h, leads into the corner there: the smaller coordinate along its two sides, less what
/// leads out of its plane.
double intoCorner(const TriMesh& mesh, HalfedgeId h, const Vec3& way) {
  const Vec3& from = mesh.position(mesh.tail(h));
  const Vec3 a = unitOf(subtract(mesh.position(mesh.head(h)), from));
  const Vec3 b = unitOf(subtract(mesh.position(mesh.tail(TriMesh::previous(h))), from));
  const double ab = dot(a, b), determinant = 1.0 - ab * ab;
  if (!(determinant > 0.0)) return -std::numeric_limits<double>::infinity();
  const double wa = dot(way, a), wb = dot(way, b);
  return std::min(wa - ab * wb, wb - ab * wa) / determinant -
         std::abs(dot(way, unitOf(cross(a, b))));
}

/// All faces that hold a vertex of the quads: one, the two of an edge or those around a vertex.
struct Around {
  CornerPlace inside;
  HalfedgeId edge, corner;  ///< on which it lies, or which leaves it
};

Around aroundOf(const TriMesh& mesh, FaceId f, const Vec3& p) {
  Around out;
  out.inside = {f, weightsIn(positionsOf(mesh, f), p)};
  const auto& weight = out.inside.weight;
  const auto isOff = [&](std::size_t k) { return weight[k] > kOnSide; };
  for (int k = 0; k < 3; ++k) {
    const auto here = at(k), next = at((k + 1) % 3), last = at((k + 2) % 3);
    if (isOff(here) && !isOff(next) && !isOff(last)) out.corner = TriMesh::halfedge(f, k);
    if (!isOff(here) && isOff(next) && isOff(last)) out.edge = TriMesh::halfedge(f, (k + 1) % 3);
  }
  return out;
}

CornerPlace placeToward(const TriMesh& mesh, const Around& around, const Vec3& p,
                        const Vec3& centre) {
  const Vec3 way = subtract(centre, p);
  if (around.corner.isValid()) {
    HalfedgeId best = around.corner;
    double most = intoCorner(mesh, best, way);
    for (const HalfedgeId h : outgoingHalfedges(mesh, mesh.tail(around.corner))) {
      const double here = intoCorner(mesh, h, way);
      if (!(here > most)) continue;
      most = here;
      best = h;
    }
    CornerPlace out{TriMesh::face(best), {}};
    out.weight[cornerOf(best)] = 1.0;
    return out;
  }
  if (!around.edge.isValid()) return around.inside;
  const HalfedgeId h = around.edge, twin = mesh.twin(h);
  const bool isAcross = twin.isValid() && inwardOf(mesh, twin, way) > inwardOf(mesh, h, way);
  return placeOn(mesh, isAcross ? twin : h, p);
}

class SideWalk {
 public:
  SideWalk(const TriMesh& mesh, const PerEdge<char>& isSeam)
      : mesh_(mesh), isSeam_(isSeam), seen_(at(mesh.faceCount()), 0) {}

  bool isCrossing(FaceId from, FaceId to, const Vec3& p, const Vec3& q) {
    if (from == to) return false;
    centre_ = scaled(add(p, q), 0.5);
    radius_ = 0.5 * kBall * distance(p, q);
    for (int n = 0; n < kBalls; ++n, radius_ *= 2) {
      if (connects(from, to, false)) return false;
      if (connects(from, to, true)) return true;
    }
    return true;
  }

 private:
  bool connects(FaceId from, FaceId to, bool overSeams) {
    ++round_;
    open_.assign(1, from);
    seen_[from] = round_;
    for (std::size_t n = 0; n < open_.size(); ++n) {
      if (open_[n] == to) return true;
      for (int k = 0; k < 3; ++k) {
        const HalfedgeId h = TriMesh::halfedge(open_[n], k), twin = mesh_.twin(h);
        if (!twin.isValid() || (!overSeams && isSeam_[mesh_.edge(h)] != 0)) continue;
        const FaceId across = TriMesh::face(twin);
        if (seen_[across] == round_ || !isNear(across)) continue;
        seen_[across] = round_;
        open_.push_back(across);
      }
    }
    return false;
  }
  /// Whether the face meets the ball.
  bool isNear(FaceId f) const {
    const std::array<Vec3, 3> corners = positionsOf(mesh_, f);
    const auto& [a, b, c] = corners;
    if (std::min({distanceTo(centre_, a, b), distanceTo(centre_, b, c),
                  distanceTo(centre_, c, a)}) <= radius_)
      return true;
    const std::array<double, 3> w = weightsIn(corners, centre_);
    const Vec3 foot = add(add(scaled(a, w[0]), scaled(b, w[1])), scaled(c, w[2]));
    return distance(foot, centre_) <= radius_;
  }

  const TriMesh& mesh_;
  const PerEdge<char>& isSeam_;
  PerFace<int> seen_;
  int round_ = 0;
  std::vector<FaceId> open_;
  Vec3 centre_{};
  double radius_ = 0.0;
};

}  // namespace

QuadPlaces cornerPlaces(const TriMesh& mesh, const QuadMesh& quads) {
  std::vector<Around> around;
  around.reserve(quads.positions.size());
  for (std::size_t v = 0; v < quads.positions.size(); ++v)
    around.push_back(aroundOf(mesh, quads.face[v], quads.positions[v]));
  QuadPlaces out(quads.quads.size());
  for (std::size_t n = 0; n < out.size(); ++n) {
    Vec3 centre{};
    for (const int v : quads.quads[n]) centre = add(centre, scaled(quads.positions[at(v)], 0.25));
    for (std::size_t k = 0; k < 4; ++k) {
      const auto v = at(quads.quads[n][k]);
      out[n][k] = placeToward(mesh, around[v], quads.positions[v], centre);
    }
  }
  return out;
}

std::vector<char> crossesSeams(const TriMesh& mesh, const QuadMesh& quads, const QuadPlaces& places,
                               const PerEdge<char>& isSeam) {
  std::vector<char> out(quads.quads.size(), 0);
  SideWalk walk(mesh, isSeam);
  for (std::size_t n = 0; n < out.size(); ++n)
    for (std::size_t k = 0; k < 4 && out[n] == 0; ++k) {
      const std::size_t next = (k + 1) % 4;
      out[n] = walk.isCrossing(places[n][k].face, places[n][next].face,
                               quads.positions[at(quads.quads[n][k])],
                               quads.positions[at(quads.quads[n][next])])
                   ? 1
                   : 0;
    }
  return out;
}

}  // namespace hgp
