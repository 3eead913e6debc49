#include "hgp/verify/features.h"

#include <cmath>
#include <numbers>

namespace hgp {
namespace {

class FeatureMeter {
 public:
  FeatureMeter(const TriMesh& mesh, const std::vector<EdgeId>& features, const CornerUv& uv,
               const PerHalfedge<AngleVector>& angle)
      : mesh_(mesh),
        uv_(uv),
        angle_(angle),
        isFeature_(at(mesh.edgeCount()), 0),
        degree_(at(mesh.vertexCount()), 0),
        isEnd_(at(mesh.vertexCount()), 0) {
    for (EdgeId e : features) isFeature_[e] = 1;
  }

  FeatureFacts run() {
    for (EdgeId e : mesh_.edges()) {
      if (!isFeature_[e]) continue;
      ++facts_.edges;
      ++degree_[mesh_.tail(mesh_.halfedge(e))];
      ++degree_[mesh_.head(mesh_.halfedge(e))];
      if (isStraight(e))
        ++facts_.straightEdges;
      else
        facts_.notStraight.push_back(e);
    }
    findEnds();
    for (VertexId v : mesh_.vertices())
      if (isEnd_[v])
        for (EdgeId e : featuresAt(v)) follow(v, e);
    for (EdgeId e : mesh_.edges())  // closed chains
      if (isFeature_[e]) follow(mesh_.tail(mesh_.halfedge(e)), e);
    return std::move(facts_);
  }

 private:
  bool isStraightFrom(HalfedgeId h) const {
    const Vec2 &a = uv_[h], &b = uv_[TriMesh::next(h)];
    return (a[0] == b[0]) != (a[1] == b[1]);
  }
  bool isStraight(EdgeId e) const {
    const HalfedgeId h = mesh_.halfedge(e);
    return isStraightFrom(h) && (mesh_.isBoundary(h) || isStraightFrom(mesh_.twin(h)));
  }

  /// Feature edges at v, also the one at which the fan of a boundary vertex ends.
  std::vector<EdgeId> featuresAt(VertexId v) const {
    std::vector<EdgeId> edges;
    HalfedgeId last;
    for (HalfedgeId h : outgoingHalfedges(mesh_, v)) {
      if (isFeature_[mesh_.edge(h)]) edges.push_back(mesh_.edge(h));
      last = TriMesh::previous(h);
    }
    if (last.isValid() && mesh_.isBoundary(last) && isFeature_[mesh_.edge(last)])
      edges.push_back(mesh_.edge(last));
    return edges;
  }

  /// Whether the sector that begins with the outgoing feature halfedge has another angle than π.
  bool isBent(HalfedgeId first) const {
    AngleSum sum;
    for (HalfedgeId h = first;;) {
      sum.add(angle_[h]);
      const HalfedgeId into = TriMesh::previous(h);
      if (mesh_.isBoundary(into) || isFeature_[mesh_.edge(into)]) break;
      h = mesh_.twin(into);
      if (h == first) break;
    }
    return std::lround(sum.radians() / (0.5 * std::numbers::pi)) != 2;
  }

  void findEnds() {
    for (VertexId v : mesh_.vertices()) {
      if (degree_[v] == 0) continue;
      isEnd_[v] = degree_[v] != 2;
      if (isEnd_[v]) continue;
      for (HalfedgeId h : outgoingHalfedges(mesh_, v))
        if (isFeature_[mesh_.edge(h)] && isBent(h)) isEnd_[v] = 1;
      facts_.corners += isEnd_[v];
    }
  }

  /// Counts the chain that leaves v along e, unless it has been counted.
  void follow(VertexId v, EdgeId e) {
    if (isCounted(e)) return;
    bool areStraight = true;
    for (;;) {
      isCounted_[e] = 1;
      areStraight = areStraight && isStraight(e);
      const HalfedgeId h = mesh_.halfedge(e);
      v = mesh_.tail(h) == v ? mesh_.head(h) : mesh_.tail(h);
      if (isEnd_[v]) break;
      EdgeId next;
      for (EdgeId other : featuresAt(v))
        if (!isCounted(other)) next = other;
      if (!next.isValid()) break;
      e = next;
    }
    ++facts_.chains;
    facts_.straightChains += areStraight;
  }
  bool isCounted(EdgeId e) const { return isCounted_[e] != 0; }

  const TriMesh& mesh_;
  const CornerUv& uv_;
  const PerHalfedge<AngleVector>& angle_;
  PerEdge<char> isFeature_;
  PerVertex<int> degree_;
  PerVertex<char> isEnd_;
  PerEdge<char> isCounted_ = PerEdge<char>(at(mesh_.edgeCount()), 0);
  FeatureFacts facts_;
};

}  // namespace

FeatureFacts measureFeatures(const TriMesh& mesh, const std::vector<EdgeId>& features,
                             const CornerUv& uv, const PerHalfedge<AngleVector>& angle) {
  if (features.empty()) return {};
  return FeatureMeter(mesh, features, uv, angle).run();
}

}  // namespace hgp
