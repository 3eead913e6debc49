#include "hgp/features/creases.h"

#include <array>
#include <cmath>

#include "hgp/base/disjoint_sets.h"
#include "hgp/base/portable_math.h"
#include "hgp/base/turns.h"
#include "hgp/mesh/vectors.h"

namespace hgp {
namespace {

/// A continuation may turn by at most 60°.
constexpr double kStraightCosine = 0.5;

class CreaseFinder {
 public:
  CreaseFinder(const TriMesh& mesh, double degrees)
      : mesh_(mesh),
        angle_(at(mesh.edgeCount()), 0.0),
        isCrease_(at(mesh.edgeCount()), 0),
        degree_(at(mesh.vertexCount()), 0),
        strong_(degrees * kPi / 180.0) {
    PerFace<Vec3> normal(at(mesh.faceCount()));
    for (FaceId f : mesh.faces()) {
      const auto [a, b, c] = mesh.corners(f);
      normal[f] = cross(subtract(mesh.position(b), mesh.position(a)),
                        subtract(mesh.position(c), mesh.position(a)));
    }
    for (EdgeId e : mesh.edges()) {
      const HalfedgeId h = mesh.halfedge(e);
      if (mesh.isBoundary(h)) continue;
      const Vec3 &n = normal[TriMesh::face(h)], &m = normal[TriMesh::face(mesh.twin(h))];
      angle_[e] = portable::atan2(norm(cross(n, m)), dot(n, m));
      if (angle_[e] > strong_) set(e, true);
    }
  }

  std::vector<EdgeId> run() {
    std::vector<EdgeId> out;
    for (VertexId v : mesh_.vertices())
      if (isFreeEnd(v)) bridge(v);
    for (VertexId v : mesh_.vertices())
      if (isFreeEnd(v)) removeSpur(v);
    for (EdgeId e : mesh_.edges())
      if (isCrease_[e]) out.push_back(e);
    return out;
  }

 private:
  void set(EdgeId e, bool isCrease) {
    isCrease_[e] = isCrease;
    for (VertexId v : {mesh_.tail(mesh_.halfedge(e)), mesh_.head(mesh_.halfedge(e))})
      degree_[v] += isCrease ? 1 : -1;
  }
  bool isFreeEnd(VertexId v) const { return degree_[v] == 1 && !mesh_.isBoundary(v); }

  VertexId otherEnd(EdgeId e, VertexId v) const {
    const HalfedgeId h = mesh_.halfedge(e);
    return mesh_.tail(h) == v ? mesh_.head(h) : mesh_.tail(h);
  }
  EdgeId onlyCrease(VertexId v) const {
    for (HalfedgeId h : outgoingHalfedges(mesh_, v))
      if (isCrease_[mesh_.edge(h)]) return mesh_.edge(h);
    return {};
  }
  Vec3 direction(VertexId from, VertexId to) const {
    const Vec3 d = subtract(mesh_.position(to), mesh_.position(from));
    const double length = norm(d);
    return length > 0.0 ? scaled(d, 1.0 / length) : d;
  }

  /// Follows weak edges from a free end; keeps them only where they lead to a crease or to the boundary.
  void bridge(VertexId v) {
    std::vector<EdgeId> path;
    VertexId before = otherEnd(onlyCrease(v), v);
    while (static_cast<int>(path.size()) < kLongestBridge) {
      EdgeId best;
      double straightest = kStraightCosine;
      for (HalfedgeId h : outgoingHalfedges(mesh_, v)) {
        const EdgeId e = mesh_.edge(h);
        if (isCrease_[e] || angle_[e] <= kWeakShare * strong_) continue;
        const double cosine = dot(direction(before, v), direction(v, mesh_.head(h)));
        if (cosine <= straightest) continue;
        straightest = cosine;
        best = e;
      }
      if (!best.isValid()) break;
      path.push_back(best);
      set(best, true);
      before = v;
      v = otherEnd(best, v);
      if (degree_[v] > 1 || mesh_.isBoundary(v)) return;
    }
    for (EdgeId e : path) set(e, false);
  }

  void removeSpur(VertexId v) {
    std::vector<EdgeId> path;
    for (EdgeId e = onlyCrease(v); e.isValid();) {
      path.push_back(e);
      if (static_cast<int>(path.size()) >= kShortestSpur) return;
      v = otherEnd(e, v);
      if (degree_[v] != 2) break;
      for (HalfedgeId h : outgoingHalfedges(mesh_, v))
        if (isCrease_[mesh_.edge(h)] && mesh_.edge(h) != path.back()) e = mesh_.edge(h);
      if (e == path.back()) break;
    }
    for (EdgeId e : path) set(e, false);
  }

  const TriMesh& mesh_;
  PerEdge<double> angle_;
  PerEdge<char> isCrease_;
  PerVertex<int> degree_;
  const double strong_;
};

}  // namespace

std::vector<EdgeId> findCreases(const TriMesh& mesh, double degrees) {
  return CreaseFinder(mesh, degrees).run();
}

int countRuns(const TriMesh& mesh, const std::vector<EdgeId>& edges) {
  PerVertex<int> degree(at(mesh.vertexCount()), 0);
  const auto ends = [&](EdgeId e) {
    const HalfedgeId h = mesh.halfedge(e);
    return std::array<VertexId, 2>{mesh.tail(h), mesh.head(h)};
  };
  for (EdgeId e : edges)
    for (VertexId v : ends(e)) ++degree[v];
  // Edges that meet at a vertex where a run goes on belong together.
  DisjointSets runs(static_cast<int>(edges.size()));
  PerVertex<int> first(at(mesh.vertexCount()), -1);
  int count = static_cast<int>(edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (VertexId v : ends(edges[i])) {
      if (degree[v] != 2) continue;
      if (first[v] < 0)
        first[v] = static_cast<int>(i);
      else
        count -= runs.join(first[v], static_cast<int>(i));
    }
  return count;
}

}  // namespace hgp
