#include "hgp/verify/seams.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hgp/base/disjoint_sets.h"
#include "hgp/base/portable_math.h"
#include "hgp/base/turns.h"

namespace hgp {
namespace {

double length(const Vec2& d) { return portable::hypot(d[0], d[1]); }

Vec2 along(const CornerUv& uv, HalfedgeId from, HalfedgeId to) {
  return {uv[to][0] - uv[from][0], uv[to][1] - uv[from][1]};
}

/// d_f and d_g: the edge as its two faces see it, both along mesh.halfedge(e).
struct TwoSides {
  Vec2 f, g;
};

MeasuredSeam measureSeam(EdgeId e, int q, const TwoSides& d) {
  MeasuredSeam seam;
  seam.edge = e;
  const double cosine = d.f[0] * d.g[0] + d.f[1] * d.g[1];
  const double sine = d.f[0] * d.g[1] - d.f[1] * d.g[0];
  seam.r = reduceTurn(std::llround(portable::atan2(sine, cosine) * q / (2.0 * kPi)), q);
  const Complex R = rotation(seam.r, q);
  seam.residual = portable::hypot(d.g[0] - (R.real() * d.f[0] - R.imag() * d.f[1]),
                                  d.g[1] - (R.imag() * d.f[0] + R.real() * d.f[1]));
  const double lengthF = length(d.f), lengthG = length(d.g);
  seam.lengthResidual = std::fabs(lengthG - lengthF);
  seam.length = std::min(lengthF, lengthG);
  return seam;
}

void applyRule(MeasuredSeam& seam, int q, const SeamRule& rule) {
  const double toNext = 2.0 * portable::sin(kPi / std::max(q, 2)) * seam.length;
  seam.hasRotation = seam.residual < kRotationShare * toNext;
  const double strict = rule.tolerance * seam.length;
  seam.allowed =
      std::max(strict, std::min(strict + rule.rounding, rule.largestRounding * seam.length));
  seam.isExplained = seam.residual <= rule.computing;
}

void measureSizes(const TriMesh& mesh, const CornerUv& uv, SeamFacts& facts) {
  double sum = 0.0;
  for (HalfedgeId h : mesh.halfedges()) {
    const Vec2 d = along(uv, h, TriMesh::next(h));
    sum += std::sqrt(d[0] * d[0] + d[1] * d[1]);
  }
  facts.maxUv = largestCoordinate(uv);
  if (mesh.halfedgeCount() > 0) facts.meanEdge = sum / mesh.halfedgeCount();
}

}  // namespace

double MeasuredSeam::relativeResidual() const {
  if (residual == 0.0) return 0.0;
  return length > 0.0 ? residual / length : std::numeric_limits<double>::infinity();
}

bool isWorse(const MeasuredSeam& a, const MeasuredSeam& b) {
  if (a.isBroken() != b.isBroken()) return a.isBroken();
  return a.residual * b.allowed > b.residual * a.allowed;
}

double largestCoordinate(const CornerUv& uv) {
  double largest = 0.0;
  for (const Vec2& p : uv) largest = std::max({largest, std::fabs(p[0]), std::fabs(p[1])});
  return largest;
}

SeamFacts measureSeams(const TriMesh& mesh, int q, const CornerUv& uv, const SeamRule& rule) {
  SeamFacts facts;
  measureSizes(mesh, uv, facts);
  DisjointSets charts(mesh.faceCount());
  facts.chartCount = mesh.faceCount();
  for (EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e), twin = mesh.twin(h);
    if (!twin.isValid()) continue;
    const HalfedgeId next = TriMesh::next(h), twinNext = TriMesh::next(twin);
    if (uv[h] == uv[twinNext] && uv[next] == uv[twin]) {
      facts.chartCount -= charts.join(TriMesh::face(h).i, TriMesh::face(twin).i);
      continue;
    }
    MeasuredSeam seam = measureSeam(e, q, {along(uv, h, next), along(uv, twinNext, twin)});
    applyRule(seam, q, rule);
    facts.seams.push_back(seam);
    if (seam.isBroken()) facts.broken.push_back(seam);
    facts.worstLengthResidual = std::max(facts.worstLengthResidual, seam.lengthResidual);
    facts.largestRelativeResidual =
        std::max(facts.largestRelativeResidual, seam.relativeResidual());
    if (!facts.worst || isWorse(seam, *facts.worst)) facts.worst = seam;
  }
  return facts;
}

SeamTurns seamTurns(const TriMesh& mesh, const SeamFacts& seams, const SeamRule& rule) {
  // A vector of length d that is off by ρ is turned by at most asin(ρ/d); two sides that are off by ρ
  // and σ by at most asin((ρ + σ)/d), because asin is convex.
  const auto turn = [](double residual, double length) {
    return residual < length ? portable::asin(residual / length) : kPi;
  };
  const auto count = static_cast<std::size_t>(mesh.vertexCount());
  SeamTurns out{PerVertex<double>(count, 0.0), PerVertex<double>(count, 0.0)};
  for (const MeasuredSeam& seam : seams.seams) {
    const HalfedgeId h = mesh.halfedge(seam.edge);
    for (VertexId v : {mesh.tail(h), mesh.head(h)}) {
      if (rule.rounding > 0.0) out.rounding[v] += turn(rule.rounding, seam.length);
      if (seam.isExplained) out.explained[v] += turn(seam.residual, seam.length);
    }
  }
  return out;
}

std::vector<MeasuredHandle> measureHandles(const TriMesh& mesh, int q,
                                           const std::vector<DualLoop>& loops,
                                           const SeamFacts& seams) {
  constexpr int kBroken = -1;
  PerEdge<int> rotationOf(static_cast<std::size_t>(mesh.edgeCount()), 0);
  for (const MeasuredSeam& seam : seams.seams)
    rotationOf[seam.edge] = seam.hasRotation ? seam.r : kBroken;
  std::vector<MeasuredHandle> handles;
  for (const DualLoop& loop : loops) {
    MeasuredHandle handle{static_cast<int>(handles.size()), {}, {}};
    long long sum = 0;
    bool isBroken = false;
    for (HalfedgeId h : loop.crossed) {
      const EdgeId e = mesh.edge(h);
      isBroken = isBroken || rotationOf[e] == kBroken;
      sum += h == mesh.halfedge(e) ? rotationOf[e] : -rotationOf[e];
    }
    if (!isBroken) handle.measured = reduceTurn(sum, q);
    handles.push_back(handle);
  }
  return handles;
}

}  // namespace hgp
