#include "hgp/verify/angles.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/turns.h"

namespace hgp {
namespace {

Vec2 subtract(const Vec2& a, const Vec2& b) { return {a[0] - b[0], a[1] - b[1]}; }

double largest(const Vec2& a) { return std::max(std::fabs(a[0]), std::fabs(a[1])); }

/// The angle between two vectors. Each coordinate carries one rounding, so the result is good to a
/// few 1e-16 absolutely, however thin the triangle is.
double angleBetween(const Vec2& a, const Vec2& b) {
  return std::atan2(std::fabs(a[0] * b[1] - a[1] * b[0]), a[0] * b[0] + a[1] * b[1]);
}

/// The same for sides so short that products of their coordinates underflow.
double angleBetweenAny(const Vec2& p, const Vec2& q) {
  Vec2 a = p, b = q;
  for (Vec2* v : {&a, &b}) {
    const double size = largest(*v);
    if (size == 0.0) return 0.0;
    const int exponent = std::ilogb(size);
    for (double& x : *v) x = std::scalbn(x, -exponent);
  }
  return angleBetween(a, b);
}

/// Sides above this have products far from underflow; overflow is out of reach because maps are brought
/// to ordinary size before they are measured.
constexpr double kSafeLength = 1e-120;

struct NearestInteger {
  int value;
  double distance;
};

/// Θ in units of 2π/q; far beyond int only for nonsense, which the cast must survive.
NearestInteger nearestTurn(double angle, int q) {
  const double x = angle * q / (2.0 * kPi);
  const double rounded = std::clamp(std::nearbyint(x), -2e9, 2e9);
  return {static_cast<int>(rounded), std::fabs(x - rounded)};
}

}  // namespace

PerHalfedge<double> computeUvAngles(const TriMesh& mesh, const CornerUv& uv) {
  PerHalfedge<double> angle(static_cast<std::size_t>(mesh.halfedgeCount()));
  for (FaceId f : mesh.faces()) {
    const HalfedgeId h[3] = {TriMesh::halfedge(f, 0), TriMesh::halfedge(f, 1),
                             TriMesh::halfedge(f, 2)};
    const Vec2 side[3] = {subtract(uv[h[1]], uv[h[0]]), subtract(uv[h[2]], uv[h[1]]),
                          subtract(uv[h[0]], uv[h[2]])};
    const double smallest = std::min({largest(side[0]), largest(side[1]), largest(side[2])});
    const auto between = smallest > kSafeLength ? angleBetween : angleBetweenAny;
    for (int k = 0; k < 3; ++k) {
      const Vec2& in = side[(k + 2) % 3];
      angle[h[k]] = between(side[k], {-in[0], -in[1]});
    }
  }
  return angle;
}

AngleFacts measureAngles(const TriMesh& mesh, const Topology& topology, const AskedAngles& asked,
                         const PerHalfedge<double>& angle, const PerVertex<double>& slack) {
  AngleFacts facts;
  PerVertex<double> sum(static_cast<std::size_t>(mesh.vertexCount()), 0.0);
  facts.smallestAngle = mesh.faceCount() > 0 ? kPi : 0.0;
  for (HalfedgeId h : mesh.halfedges()) {
    sum[mesh.tail(h)] += angle[h];
    facts.smallestAngle = std::min(facts.smallestAngle, angle[h]);
  }
  for (VertexId v : mesh.vertices()) {
    if (mesh.isIsolated(v)) continue;
    if (mesh.isBoundary(v)) {
      if (sum[v] > 2.0 * kPi + kAngleTolerance) facts.overlapping.push_back(v);
      continue;
    }
    const NearestInteger k = nearestTurn(sum[v], asked.q);
    MeasuredCone cone{v, asked.k[v], k.value, k.distance};
    if (asked.isAnyConeAllowed && !asked.isCone[v]) cone.asked = std::max(1, k.value);
    if (asked.isCone[v] || k.value != asked.q) facts.cones.push_back(cone);
    const double allowance = std::min(kAngleTolerance + slack[v], kLargestAngleAllowance);
    if (cone.measured != cone.asked || !(cone.distance <= allowance)) facts.wrong.push_back(cone);
    facts.turnSum += asked.q - k.value;
    if (k.distance > facts.worstDistance || !facts.worstVertex.isValid()) {
      facts.worstDistance = k.distance;
      facts.worstVertex = v;
    }
  }
  for (std::size_t j = 0; j < topology.loops.size(); ++j) {
    double turning = 0.0, loopSlack = 0.0;
    for (HalfedgeId h : topology.loops[j].halfedges) {
      turning += kPi - sum[mesh.tail(h)];
      loopSlack += slack[mesh.tail(h)];
    }
    const NearestInteger l = nearestTurn(turning, asked.q);
    MeasuredTurning measured{LoopId(static_cast<int>(j)), {}, l.value, l.distance, false};
    if (j < asked.turning.size()) measured.asked = asked.turning[j];
    const double allowance = std::min(kAngleTolerance + loopSlack, kLargestAngleAllowance);
    measured.isWrong = !(l.distance <= allowance) || measured.asked.value_or(l.value) != l.value;
    facts.turnSum += l.value;
    facts.turnings.push_back(measured);
  }
  return facts;
}

}  // namespace hgp
