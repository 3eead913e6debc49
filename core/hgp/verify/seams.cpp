#include "hgp/verify/seams.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/turns.h"
#include "hgp/mesh/edge_table.h"

namespace hgp {
namespace {

double length(const Vec2& d) { return std::hypot(d[0], d[1]); }

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
  seam.r = reduceTurn(std::llround(std::atan2(sine, cosine) * q / (2.0 * kPi)), q);
  const Complex R = rotation(seam.r, q);
  seam.residual = std::hypot(d.g[0] - (R.real() * d.f[0] - R.imag() * d.f[1]),
                             d.g[1] - (R.imag() * d.f[0] + R.real() * d.f[1]));
  const double lengthF = length(d.f), lengthG = length(d.g);
  seam.lengthResidual = std::fabs(lengthG - lengthF);
  seam.length = std::min(lengthF, lengthG);
  return seam;
}

bool isAccepted(const MeasuredSeam& seam, int q, double tolerance) {
  const double toNext = 2.0 * std::sin(kPi / std::max(q, 2)) * seam.length;
  return seam.residual <= tolerance && seam.residual < kRotationShare * toNext;
}

void measureSizes(const TriMesh& mesh, const CornerUv& uv, SeamFacts& facts) {
  double sum = 0.0;
  for (HalfedgeId h : mesh.halfedges()) {
    const Vec2 d = along(uv, h, TriMesh::next(h));
    sum += std::sqrt(d[0] * d[0] + d[1] * d[1]);
    facts.maxUv = std::max({facts.maxUv, std::fabs(uv[h][0]), std::fabs(uv[h][1])});
  }
  if (mesh.halfedgeCount() > 0) facts.meanEdge = sum / mesh.halfedgeCount();
}

}  // namespace

SeamFacts measureSeams(const TriMesh& mesh, int q, const CornerUv& uv, double relativeTolerance) {
  SeamFacts facts;
  measureSizes(mesh, uv, facts);
  facts.tolerance = relativeTolerance * facts.maxUv;
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
    const MeasuredSeam seam = measureSeam(e, q, {along(uv, h, next), along(uv, twinNext, twin)});
    facts.seams.push_back(seam);
    if (!isAccepted(seam, q, facts.tolerance)) facts.broken.push_back(seam);
    facts.worstLengthResidual = std::max(facts.worstLengthResidual, seam.lengthResidual);
    if (seam.residual > facts.worstResidual || !facts.worstEdge.isValid()) {
      facts.worstResidual = seam.residual;
      facts.worstEdge = e;
    }
  }
  return facts;
}

PerVertex<double> seamSlack(const TriMesh& mesh, int q, const SeamFacts& seams) {
  // An edge with residual ρ and length d is turned by at most asin(ρ/d) ≤ π/2 · ρ/d.
  PerVertex<double> slack(static_cast<std::size_t>(mesh.vertexCount()), 0.0);
  for (const MeasuredSeam& seam : seams.seams) {
    if (!isAccepted(seam, q, seams.tolerance)) continue;
    const double turned = 0.25 * q * seam.residual / seam.length;
    const HalfedgeId h = mesh.halfedge(seam.edge);
    slack[mesh.tail(h)] += turned;
    slack[mesh.head(h)] += turned;
  }
  return slack;
}

std::vector<MeasuredHandle> measureHandles(const TriMesh& mesh, int q,
                                           const std::vector<DualLoop>& loops,
                                           const SeamFacts& seams) {
  constexpr int kBroken = -1;
  PerEdge<int> rotationOf(static_cast<std::size_t>(mesh.edgeCount()), 0);
  for (const MeasuredSeam& seam : seams.seams) rotationOf[seam.edge] = seam.r;
  for (const MeasuredSeam& seam : seams.broken) rotationOf[seam.edge] = kBroken;
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
