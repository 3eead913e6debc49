#include "hgp/verify/distortion.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <vector>

#include "hgp/base/parallel.h"
#include "hgp/base/portable_math.h"
#include "hgp/mesh/defects.h"
#include "hgp/verify/orientation.h"

namespace hgp {
namespace {

/// An area below this fraction of its two products may have a relative rounding error above 1e-6.
constexpr double kCancelled = 1e-9;
/// Triangles that a thread takes at a time.
constexpr int kTrianglesAtOnce = 2048;

/// One triangle on the surface, laid flat with its first side on the real axis, and its sides in the map.
struct TriangleAreas {
  double area = 0;  ///< on the surface; 0: the triangle is not measured
  double uvArea = 0;
  double base = 0, height = 0, foot = 0;
  Vec2 p{}, q{};
  FaceId face;
};

/// One triangle's numbers before the global scale is known.
struct TriangleMap {
  double area = 0, uvArea = 0;
  double mu = 0;
  double logScale = 0;  ///< log₂(uv area / surface area)
  double stretch = 0;   ///< σ₁² + σ₂²
  double shrink = 0;    ///< σ₁⁻² + σ₂⁻²
  FaceId face;
};

/// 2^−exponent of the largest coordinate difference to the first vertex: keeps squares in range.
double surfaceScale(const TriMesh& mesh) {
  double largest = 0.0;
  const Vec3& origin = mesh.position(VertexId(0));
  for (VertexId v : mesh.vertices())
    for (std::size_t n = 0; n < 3; ++n)
      largest = std::max(largest, std::fabs(mesh.position(v)[n] - origin[n]));
  return largest > 0.0 && std::isfinite(largest) ? std::scalbn(1.0, -std::ilogb(largest)) : 1.0;
}

TriangleAreas measureAreas(const TriMesh& mesh, FaceId f, double scale, const CornerUv& uv) {
  const auto [a, b, c] = mesh.corners(f);
  Vec3 ab, ac;
  for (std::size_t n = 0; n < 3; ++n) {
    ab[n] = (mesh.position(b)[n] - mesh.position(a)[n]) * scale;
    ac[n] = (mesh.position(c)[n] - mesh.position(a)[n]) * scale;
  }
  const auto dot = [](const Vec3& p, const Vec3& q) {
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
  };
  const Vec3 cross{ab[1] * ac[2] - ab[2] * ac[1], ab[2] * ac[0] - ab[0] * ac[2],
                   ab[0] * ac[1] - ab[1] * ac[0]};
  const double base = std::sqrt(dot(ab, ab)), twiceArea = std::sqrt(dot(cross, cross));
  TriangleAreas t;
  t.face = f;
  // Distortion is not defined for triangles without area on the surface.
  if (!(twiceArea > 0.0) || hasNoArea(mesh.position(a), mesh.position(b), mesh.position(c)))
    return t;

  const HalfedgeId h = TriMesh::halfedge(f, 0);
  const Vec2 &u0 = uv[h], &u1 = uv[TriMesh::next(h)], &u2 = uv[TriMesh::previous(h)];
  t.p = {u1[0] - u0[0], u1[1] - u0[1]};
  t.q = {u2[0] - u0[0], u2[1] - u0[1]};
  t.base = base;
  t.height = twiceArea / base;
  t.foot = dot(ab, ac) / (base * base);
  const double left = t.p[0] * t.q[1], right = t.p[1] * t.q[0];
  // The triangle is known to be positive; the range of areas needs the smallest without rounding.
  const double det = left - right;
  const bool isSure =
      det >= kCancelled * (std::fabs(left) + std::fabs(right)) && std::isfinite(det);
  t.area = 0.5 * twiceArea;
  t.uvArea = std::max(0.5 * (isSure ? det : exactTwiceArea(u0, u1, u2)), DBL_MIN);
  return t;
}

/// f_z and f_z̄.
TriangleMap measureTriangle(const TriangleAreas& t) {
  TriangleMap out;
  out.face = t.face;
  if (!(t.area > 0.0)) return out;
  const Vec2 fx{t.p[0] / t.base, t.p[1] / t.base};
  const Vec2 fy{(t.q[0] - t.foot * t.p[0]) / t.height, (t.q[1] - t.foot * t.p[1]) / t.height};
  const double conformal =
      0.5 * std::sqrt((fx[0] + fy[1]) * (fx[0] + fy[1]) + (fx[1] - fy[0]) * (fx[1] - fy[0]));
  const double anti =
      0.5 * std::sqrt((fx[0] - fy[1]) * (fx[0] - fy[1]) + (fx[1] + fy[0]) * (fx[1] + fy[0]));
  out.area = t.area;
  out.uvArea = t.uvArea;
  out.mu = conformal > 0.0 ? std::min(1.0, anti / conformal) : 1.0;
  out.logScale = portable::log2(t.uvArea / t.area);
  const double large = std::max(conformal + anti, DBL_MIN), small = t.uvArea / t.area / large;
  out.stretch = large * large + small * small;
  out.shrink = 1.0 / (large * large) + 1.0 / (small * small);
  return out;
}

/// The smallest value such that values up to it have the fraction `share` of all weight; reorders the pairs. Linear.
double weightedQuantile(std::vector<std::pair<double, double>>& valueWeight, double share) {
  double total = 0.0;
  for (const auto& [value, weight] : valueWeight) total += weight;
  double rest = share * total;
  auto first = valueWeight.begin(), last = valueWeight.end();
  if (first == last) return 0.0;
  while (last - first > 1) {
    const auto middle = first + (last - first) / 2;
    std::nth_element(first, middle, last);
    double below = 0.0;
    for (auto it = first; it != middle; ++it) below += it->second;
    if (below >= rest) {
      last = middle;
    } else {
      rest -= below;
      first = middle;
    }
  }
  return first->first;
}

double finite(double x) { return x <= DBL_MAX ? x : DBL_MAX; }

/// Area-weighted sums over all measured triangles.
struct Sums {
  double area = 0, logScale = 0, mu = 0, stretch = 0, shrink = 0;
  void add(const TriangleMap& t) {
    area += t.area;
    logScale += t.area * t.logScale;
    mu += t.area * t.mu;
    stretch += t.area * t.stretch;
    shrink += t.area * t.shrink;
  }
};

/// Of the positive triangles with area on the surface, what `measure` makes of them.
template <class Measured>
std::vector<Measured> measurePositive(const TriMesh& mesh, const OrientationFacts& orientation,
                                      const CornerUv& uv,
                                      Measured (*measure)(const TriangleAreas&)) {
  const double scale = mesh.vertexCount() > 0 ? surfaceScale(mesh) : 1.0;
  std::vector<char> isSkipped(static_cast<std::size_t>(mesh.faceCount()), 0);
  for (FaceId f : orientation.notPositive) isSkipped[static_cast<std::size_t>(f.i)] = 1;
  std::vector<Measured> triangles(isSkipped.size());
  parallelFor(mesh.faceCount(), kTrianglesAtOnce, [&](int f) {
    const auto at = static_cast<std::size_t>(f);
    if (!isSkipped[at]) triangles[at] = measure(measureAreas(mesh, FaceId(f), scale, uv));
  });
  std::erase_if(triangles, [](const Measured& t) { return !(t.area > 0.0); });
  return triangles;
}

/// How far areas are apart.
template <class Measured>
void measureSpan(const std::vector<Measured>& triangles, DistortionFacts& facts) {
  double area = 0.0, uvArea = 0.0, smallestScale = DBL_MAX, smallestArea = DBL_MAX;
  for (const Measured& t : triangles) {
    area += t.area;
    uvArea += t.uvArea;
    smallestArea = std::min(smallestArea, t.uvArea);
    if (!(t.uvArea / t.area < smallestScale)) continue;
    smallestScale = t.uvArea / t.area;
    facts.smallestArea = t.face;
  }
  facts.areaSpan = smallestScale / (uvArea / area);
  facts.smallestToMeanArea = smallestArea / (uvArea / facts.triangleCount);
}

/// The measurements that need the best global scale of areas or an order of the triangles.
void measureSpread(const std::vector<TriangleMap>& triangles, const Sums& sums,
                   DistortionFacts& facts) {
  double squares = 0.0;
  std::vector<std::pair<double, double>> mu, logArea, size;
  mu.reserve(triangles.size());
  size.reserve(triangles.size());
  logArea.reserve(triangles.size());
  facts.minLogArea = DBL_MAX;
  facts.maxLogArea = -DBL_MAX;
  for (const TriangleMap& t : triangles) {
    const double log = t.logScale - sums.logScale / sums.area;
    squares += t.area * log * log;
    mu.emplace_back(t.mu, t.area);
    logArea.emplace_back(std::fabs(log), t.area);
    size.emplace_back(t.uvArea / t.area, t.area);
    facts.minLogArea = std::min(facts.minLogArea, log);
    facts.maxLogArea = std::max(facts.maxLogArea, log);
    if (t.mu > facts.maxMu || !facts.worstMu.isValid()) {
      facts.maxMu = t.mu;
      facts.worstMu = t.face;
    }
  }
  facts.rmsLogArea = std::sqrt(squares / sums.area);
  const auto measureMu = [&] {
    facts.p95Mu = weightedQuantile(mu, 0.95);
    facts.medianMu = weightedQuantile(mu, 0.5);
  };
  const auto measureSize = [&] {
    facts.sizeSpread =
        finite(std::sqrt(weightedQuantile(size, 0.95) / weightedQuantile(size, 0.05)));
  };
  parallelInvoke(
      {measureMu, measureSize, [&] { facts.p95LogArea = weightedQuantile(logArea, 0.95); }});
}

}  // namespace

DistortionFacts measureDistortion(const TriMesh& mesh, const OrientationFacts& orientation,
                                  const CornerUv& uv) {
  DistortionFacts facts;
  const std::vector<TriangleMap> triangles =
      measurePositive(mesh, orientation, uv, measureTriangle);
  facts.triangleCount = static_cast<int>(triangles.size());
  if (triangles.empty()) return facts;
  Sums sums;
  for (const TriangleMap& t : triangles) sums.add(t);
  facts.meanMu = sums.mu / sums.area;
  // Scaling uv by s turns the energy into s²·stretch + shrink/s², least at 2√(stretch · shrink).
  facts.symmetricDirichlet = finite(std::max(
      0.0, 2.0 * std::sqrt(sums.stretch / sums.area) * std::sqrt(sums.shrink / sums.area) - 4.0));
  measureSpread(triangles, sums, facts);
  measureSpan(triangles, facts);
  return facts;
}

DistortionFacts measureAreaSpan(const TriMesh& mesh, const OrientationFacts& orientation,
                                const CornerUv& uv) {
  DistortionFacts facts;
  const auto triangles = measurePositive<TriangleAreas>(mesh, orientation, uv,
                                                        [](const TriangleAreas& t) { return t; });
  facts.triangleCount = static_cast<int>(triangles.size());
  if (!triangles.empty()) measureSpan(triangles, facts);
  return facts;
}

}  // namespace hgp
