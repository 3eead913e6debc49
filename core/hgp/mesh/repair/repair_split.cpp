#include <algorithm>
#include <cmath>
#include <map>

#include "hgp/base/check.h"
#include "hgp/base/counted.h"
#include "hgp/base/disjoint_sets.h"
#include "hgp/base/ids.h"
#include "hgp/base/stable_order.h"
#include "hgp/mesh/edge_table.h"
#include "hgp/mesh/repair/repair_steps.h"
#include "hgp/mesh/vectors.h"

namespace hgp {
namespace {

/// Direction in which the face leaves the edge, perpendicular to it and of length 1.
Vec3 leavingDirection(const MeshData& mesh, int side, const Vec3& along) {
  const Vec3& tail = mesh.positions[at(sideTail(mesh.triangles, side))];
  const Vec3& apex = mesh.positions[at(sideTail(mesh.triangles, nextSide(nextSide(side))))];
  Vec3 d = subtract(apex, tail);
  const double onEdge = dot(d, along) / dot(along, along);
  for (std::size_t n = 0; n < 3; ++n) d[n] -= onEdge * along[n];
  const double length = norm(d);
  if (length > 0.0)
    for (double& x : d) x /= length;
  return d;
}

/// Pairs the faces on an edge that run along it in opposite directions: flattest first and, of
/// equally flat ones, those with the solid between them (two boxes touching along an edge come apart).
std::vector<std::pair<int, int>> pairSides(const MeshData& mesh, const EdgeTable& table, int e) {
  const auto [a, b] = table.vertices(e);
  const Vec3 along = subtract(mesh.positions[at(b)], mesh.positions[at(a)]);
  struct Candidate {
    double bend;
    bool isHollow;
    int forward, backward;
  };
  std::vector<Candidate> candidates;
  for (const int* s = table.begin(e); s != table.end(e); ++s)
    for (const int* t = table.begin(e); t != table.end(e); ++t) {
      if (sideTail(mesh.triangles, *s) != a || sideTail(mesh.triangles, *t) != b) continue;
      const Vec3 p = leavingDirection(mesh, *s, along), q = leavingDirection(mesh, *t, along);
      // The solid lies on the left of the forward face when going from it to the backward one.
      const bool isHollow = dot(cross(p, q), along) > 0.0;
      candidates.push_back({std::round(dot(p, q) * 1e6), isHollow, *s, *t});
    }
  sortStably(candidates, [](const auto& x, const auto& y) {
    return x.bend != y.bend ? x.bend < y.bend : x.isHollow < y.isHollow;
  });
  std::vector<std::pair<int, int>> pairs;
  std::vector<int> used;
  const auto isUsed = [&](int s) { return std::find(used.begin(), used.end(), s) != used.end(); };
  for (const Candidate& c : candidates) {
    if (isUsed(c.forward) || isUsed(c.backward)) continue;
    used.insert(used.end(), {c.forward, c.backward});
    pairs.emplace_back(c.forward, c.backward);
  }
  return pairs;
}

struct SplitCount {
  int copies = 0;
  int badEdges = 0;
  int cutEdges = 0;
};

/// Gives every set of corners at a vertex except the first one a copy of the vertex. @return  number of copies
int separateFans(FixResult& result, DisjointSets& fans, const std::vector<char>& isSkipped) {
  MeshData& mesh = result.mesh;
  std::vector<int> owner(mesh.positions.size(), -1);
  std::map<int, int> copyOf;
  for (std::size_t corner = 0; corner < 3 * mesh.triangles.size(); ++corner) {
    if (isSkipped[corner / 3]) continue;
    int& v = mesh.triangles[corner / 3][corner % 3];
    const int fan = fans.root(static_cast<int>(corner));
    if (owner[at(v)] < 0) owner[at(v)] = fan;
    if (owner[at(v)] == fan) continue;
    const auto [it, isNew] = copyOf.try_emplace(fan, static_cast<int>(mesh.positions.size()));
    if (isNew) {
      const Vec3 position = mesh.positions[at(v)];
      mesh.positions.push_back(position);
      result.vertexOrigin.push_back(result.vertexOrigin[at(v)]);
    }
    v = it->second;
  }
  return static_cast<int>(copyOf.size());
}

/// One pass. With isCutOpen, faces on an edge with more than two are not paired at all: each corner
/// link is then cut at every such edge, after which no copy of the edge has more than two faces.
SplitCount splitOnce(FixResult& result, bool isCutOpen, bool cutsInconsistent) {
  const MeshData& mesh = result.mesh;
  std::vector<char> isSkipped(mesh.triangles.size(), 0);
  for (std::size_t f = 0; f < isSkipped.size(); ++f) {
    const auto& t = mesh.triangles[f];
    isSkipped[f] = t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
  }
  const auto vertexCount = static_cast<int>(mesh.positions.size());
  const EdgeTable table(mesh.triangles, isSkipped, vertexCount);
  DisjointSets fans(static_cast<int>(3 * mesh.triangles.size()));
  const auto cornerAt = [&](int side, int v) {
    return sideTail(mesh.triangles, side) == v ? side : nextSide(side);
  };
  const auto join = [&](int e, int s, int t) {
    for (int v : table.vertices(e)) fans.join(cornerAt(s, v), cornerAt(t, v));
  };
  SplitCount count;
  for (int e = 0; e < table.edgeCount(); ++e) {
    if (table.faceCount(e) == 2) {
      const int s = table.begin(e)[0], t = table.begin(e)[1];
      const bool isConsistent = sideTail(mesh.triangles, s) != sideTail(mesh.triangles, t);
      if (isConsistent || !cutsInconsistent)
        join(e, s, t);
      else
        ++count.cutEdges;
    }
    if (table.faceCount(e) <= 2) continue;
    ++count.badEdges;
    if (isCutOpen) continue;
    for (const auto& [s, t] : pairSides(mesh, table, e)) join(e, s, t);
  }
  count.copies = separateFans(result, fans, isSkipped);
  return count;
}

}  // namespace

void splitNonManifold(FixResult& result, int oneSided) {
  const SplitCount paired = splitOnce(result, false, oneSided > 0);
  int copies = paired.copies;
  // Cuts open edges whose two ends pairing has joined again.
  if (paired.badEdges > 0) copies += splitOnce(result, true, oneSided > 0).copies;
  // A cut whose ends are not on the boundary leaves an edge with both ends shared, which must be cut again.
  int cut = paired.cutEdges;
  if (oneSided > 0)
    result.notes.push_back(
        Note("repair-one-sided-cut", {{"components", oneSided}, {"edges", cut}}));
  if (copies == 0) return;
  result.notes.push_back(Note("repair-split", {{"vertices", copies}, {"edges", paired.badEdges}}));
}

}  // namespace hgp
