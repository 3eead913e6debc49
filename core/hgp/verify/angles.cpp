#include "hgp/verify/angles.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/parallel.h"
#include "hgp/base/portable_math.h"
#include "hgp/base/turns.h"

namespace hgp {
namespace {

Vec2 subtract(const Vec2& a, const Vec2& b) { return {a[0] - b[0], a[1] - b[1]}; }

double largest(const Vec2& a) { return std::max(std::fabs(a[0]), std::fabs(a[1])); }

/// The angle between two vectors. Each coordinate has one rounding error, so the absolute error is a
/// few 1e-16, however thin the triangle is.
AngleVector angleBetween(const Vec2& a, const Vec2& b) {
  const double cosine = a[0] * b[0] + a[1] * b[1], sine = std::fabs(a[0] * b[1] - a[1] * b[0]);
  const double size = std::max(std::fabs(cosine), sine);
  if (!(size > 0.0)) return {1.0, 0.0};
  return {cosine / size, sine / size};
}

/// The same for sides so short that products of their coordinates underflow.
AngleVector angleBetweenAny(const Vec2& p, const Vec2& q) {
  Vec2 a = p, b = q;
  for (Vec2* v : {&a, &b}) {
    const double size = largest(*v);
    if (size == 0.0) return {1.0, 0.0};
    const int exponent = std::ilogb(size);
    for (double& x : *v) x = std::scalbn(x, -exponent);
  }
  return angleBetween(a, b);
}

bool isSmaller(const AngleVector& a, const AngleVector& b) { return b[0] * a[1] < b[1] * a[0]; }

double radiansOf(const AngleVector& angle) { return portable::atan2(angle[1], angle[0]); }

/// Directions are made shorter beyond this length; by a power of two, so that nothing is rounded.
constexpr double kLongDirection = 0x1p500;

/// Products of sides above this are far from underflow. They cannot overflow, because maps are scaled
/// to ordinary size before they are measured.
constexpr double kSafeLength = 1e-120;
/// Triangles that a thread takes at a time.
constexpr int kFacesAtOnce = 2048;

/// The integer n with 2πn/q nearest to an angle, clamped so that the cast is defined even for meaningless angles.
int nearestTurn(double angle, int q) {
  return static_cast<int>(std::clamp(std::nearbyint(angle * q / (2.0 * kPi)), -2e9, 2e9));
}

PerVertex<double> angleSums(const TriMesh& mesh, const PerHalfedge<AngleVector>& angle) {
  PerVertex<AngleSum> sums(static_cast<std::size_t>(mesh.vertexCount()));
  for (HalfedgeId h : mesh.halfedges()) sums[mesh.tail(h)].add(angle[h]);
  PerVertex<double> radians(sums.size());
  for (VertexId v : mesh.vertices()) radians[v] = sums[v].radians();
  return radians;
}

double smallestAngle(const TriMesh& mesh, const PerHalfedge<AngleVector>& angle) {
  if (mesh.faceCount() == 0) return 0.0;
  AngleVector smallest{-1.0, 0.0};
  for (const AngleVector& one : angle)
    if (isSmaller(one, smallest)) smallest = one;
  return radiansOf(smallest);
}

AngleDistance compare(double angle, int turn, int q, const AngleRule& rule, double rounding,
                      double explained) {
  AngleDistance out;
  out.excess = angle - turnAngle(turn, q);
  out.distance = std::fabs(out.excess);
  const double excused = std::min(rule.tolerance + rounding, rule.largestRounding);
  out.allowed = std::min(std::max(rule.tolerance, excused), turnAngle(kLargestAngleAllowance, q));
  out.isExplained = out.distance <= rule.tolerance + explained;
  return out;
}

}  // namespace

void AngleSum::add(const AngleVector& angle) {
  const Vec2 d = direction_;
  // Without the sign of a zero, which would stand for the other side of −π.
  direction_ = {d[0] * angle[0] - d[1] * angle[1], d[0] * angle[1] + d[1] * angle[0] + 0.0};
  // Without branches, which no processor would predict.
  const int wasPositive = int{d[1] > 0.0} | (int{d[1] == 0.0} & int{d[0] < 0.0});  // in (0, π]
  const auto [x, y] = direction_;
  const int isPast = int{y < 0.0} | (int{y == 0.0} & int{x > 0.0});
  turns_ += wasPositive & isPast;
  if (std::max(std::fabs(direction_[0]), std::fabs(direction_[1])) > kLongDirection)
    direction_ = {direction_[0] / kLongDirection, direction_[1] / kLongDirection};
}

double AngleSum::radians() const { return radiansOf(direction_) + 2.0 * kPi * turns_; }

PerHalfedge<AngleVector> computeUvAngles(const TriMesh& mesh, const CornerUv& uv) {
  PerHalfedge<AngleVector> angle(static_cast<std::size_t>(mesh.halfedgeCount()));
  parallelFor(mesh.faceCount(), kFacesAtOnce, [&](int face) {
    const FaceId f(face);
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
  });
  return angle;
}

AngleFacts measureAngles(const TriMesh& mesh, const Topology& topology, const AskedAngles& asked,
                         const PerHalfedge<AngleVector>& angle, const AngleRule& rule) {
  AngleFacts facts;
  const PerVertex<double> sum = angleSums(mesh, angle);
  facts.smallestAngle = smallestAngle(mesh, angle);
  for (VertexId v : mesh.vertices()) {
    if (mesh.isIsolated(v)) continue;
    const bool isInside = !mesh.isBoundary(v);
    if (!isInside && sum[v] > 2.0 * kPi + rule.tolerance) facts.overlapping.push_back(v);
    if (!isInside && asked.k[v] == 0) continue;
    const int k = nearestTurn(sum[v], asked.q);
    MeasuredCone cone{compare(sum[v], k, asked.q, rule, rule.rounding[v], rule.explained[v]), v,
                      asked.k[v], k};
    if (isInside && asked.isAnyConeAllowed && !asked.isCone[v]) cone.asked = std::max(1, k);
    if (cone.measured != cone.asked || cone.isTooFar()) facts.wrong.push_back(cone);
    if (!isInside) continue;
    if (asked.isCone[v] || k != asked.q) facts.cones.push_back(cone);
    facts.turnSum += asked.q - k;
    if (cone.distance > facts.worstDistance || !facts.worstVertex.isValid()) {
      facts.worstDistance = cone.distance;
      facts.worstVertex = v;
      facts.allowedThere = cone.allowed;
    }
  }
  for (std::size_t j = 0; j < topology.loops.size(); ++j) {
    double turning = 0.0, rounding = 0.0, explained = 0.0;
    for (HalfedgeId h : topology.loops[j].halfedges) {
      turning += kPi - sum[mesh.tail(h)];
      rounding += rule.rounding[mesh.tail(h)];
      explained += rule.explained[mesh.tail(h)];
    }
    const int l = nearestTurn(turning, asked.q);
    MeasuredTurning measured{compare(turning, l, asked.q, rule, rounding, explained),
                             LoopId(static_cast<int>(j)), std::nullopt, l, false};
    if (j < asked.turning.size()) measured.asked = asked.turning[j];
    measured.isWrong = measured.isTooFar() || measured.asked.value_or(l) != l;
    facts.turnSum += l;
    facts.turnings.push_back(measured);
  }
  return facts;
}

}  // namespace hgp
