#include "hgp/quads/surface_walk.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/check.h"
#include "hgp/mesh/unit_scale.h"
#include "hgp/mesh/vectors.h"

namespace hgp {
namespace {

constexpr int kMaxSteps = 1000;

double crossed(const Vec2& a, const Vec2& b) { return a[0] * b[1] - a[1] * b[0]; }
Vec2 between(const Vec2& a, const Vec2& b) { return {b[0] - a[0], b[1] - a[1]}; }

/// A face in the plane: its corners from that of `first` on.
struct LaidOut {
  HalfedgeId first;
  std::array<Vec2, 3> corner{};
};

/// The corner opposite to h, where the ends of h lie at a and b; nothing where the face has no area.
std::optional<Vec2> apexOf(const TriMesh& mesh, HalfedgeId h, const Vec2& a, const Vec2& b) {
  const Vec3& p = mesh.position(mesh.tail(h));
  const Vec3 edge = subtract(mesh.position(mesh.head(h)), p);
  const Vec3 side = subtract(mesh.position(mesh.tail(TriMesh::previous(h))), p);
  const double square = dot(edge, edge);
  const double height = norm(cross(edge, side));
  if (!(square > 0.0) || !(height > 0.0)) return {};
  const double along = dot(edge, side) / square, across = height / square;
  const Vec2 e = between(a, b);
  return Vec2{a[0] + along * e[0] - across * e[1], a[1] + along * e[1] + across * e[0]};
}

std::optional<LaidOut> laidOut(const TriMesh& mesh, HalfedgeId first, const Vec2& a,
                               const Vec2& b) {
  const std::optional<Vec2> apex = apexOf(mesh, first, a, b);
  if (!apex) return {};
  return LaidOut{first, {a, b, *apex}};
}

/// Shares of the corners in a point, from `first` on.
std::array<double, 3> shares(const LaidOut& face, const Vec2& p) {
  std::array<double, 3> out{};
  double total = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2 &a = face.corner[(k + 1) % 3], &b = face.corner[(k + 2) % 3];
    out[k] = std::max(0.0, crossed(between(a, b), between(a, p)));
    total += out[k];
  }
  for (double& share : out) share /= total;
  return out;
}

SurfacePoint pointIn(const TriMesh& mesh, const LaidOut& face, const Vec2& p) {
  SurfacePoint out{TriMesh::face(face.first), {}, {}};
  const std::array<double, 3> share = shares(face, p);
  HalfedgeId h = face.first;
  std::array<Vec3, 3> corner{};
  for (std::size_t k = 0; k < 3; ++k, h = TriMesh::next(h)) {
    corner[k] = mesh.position(mesh.tail(h));
    out.position = add(out.position, scaled(corner[k], share[k]));
  }
  const Vec3 n = cross(subtract(corner[1], corner[0]), subtract(corner[2], corner[0]));
  out.normal = scaled(n, 1.0 / norm(n));
  return out;
}

}  // namespace

std::optional<SurfacePoint> walkStraight(const TriMesh& mesh, const SurfacePoint& start,
                                         const std::array<double, 2>& direction, double length) {
  const HalfedgeId first = TriMesh::halfedge(start.face, 0);
  const Vec3& origin = mesh.position(mesh.tail(first));
  const Vec3 edge = subtract(mesh.position(mesh.head(first)), origin);
  const Vec3 offset = subtract(start.position, origin);
  const double base = norm(edge);
  std::optional<LaidOut> face = laidOut(mesh, first, {0.0, 0.0}, {base, 0.0});
  if (!face) return {};
  const Vec3 along = scaled(edge, unitScale(base));
  const Vec3 n = cross(along, subtract(mesh.position(mesh.tail(TriMesh::previous(first))), origin));
  Vec2 p{dot(offset, edge) / base, dot(cross(n, along), offset) / (norm(n) * norm(along))};

  HalfedgeId entered;
  for (int step = 0; step < kMaxSteps; ++step) {
    // The first side that the walk leaves through.
    double nearest = length;
    std::size_t exit = 3;
    HalfedgeId h = face->first;
    for (std::size_t k = 0; k < 3; ++k, h = TriMesh::next(h)) {
      const Vec2 &a = face->corner[k], side = between(a, face->corner[(k + 1) % 3]);
      const double outwards = crossed(direction, side);
      if (h == entered || !(outwards > 0.0)) continue;
      const double t = std::max(0.0, crossed(between(p, a), side) / outwards);
      if (t < nearest) {
        nearest = t;
        exit = k;
      }
    }
    p = {p[0] + nearest * direction[0], p[1] + nearest * direction[1]};
    length -= nearest;
    if (exit == 3) return pointIn(mesh, *face, p);
    h = face->first;
    for (std::size_t k = 0; k < exit; ++k) h = TriMesh::next(h);
    entered = mesh.twin(h);
    if (!entered.isValid()) return {};
    const Vec2 a = face->corner[exit], b = face->corner[(exit + 1) % 3];
    face = laidOut(mesh, entered, b, a);
    if (!face) return {};
  }
  return {};
}

}  // namespace hgp
