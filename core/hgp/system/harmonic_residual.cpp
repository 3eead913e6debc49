#include "hgp/system/harmonic_residual.h"

#include <cmath>

#include "hgp/base/portable_math.h"
#include "hgp/seams/seam_structure.h"
#include "hgp/system/weights.h"

namespace hgp {
namespace {

class Residual {
 public:
  Residual(const TriMesh& mesh, const Geometry& geometry, const UvMap& map, int q, WeightKind kind)
      : mesh_(mesh), geometry_(geometry), map_(map), q_(q), kind_(kind) {}

  struct AtVertex {
    double residual = 0;
    double meanEdge = 0;
  };

  AtVertex at(VertexId v) const {
    Complex sum = 0;
    double weight = 0, length = 0;
    int sides = 0, turn = 0;
    for (HalfedgeId h : outgoingHalfedges(mesh_, v)) {
      const CornerWeights w = cornerWeights(kind_, mesh_, geometry_, h);
      const Complex toHead = uv(TriMesh::next(h)) - uv(h);
      const Complex toThird = uv(TriMesh::previous(h)) - uv(h);
      const Complex here = w.toHead * toHead + w.toThird * toThird;
      sum -= turn == 0 ? here : rotation(-turn, q_) * here;
      weight += w.toHead + w.toThird;
      length += portable::abs(toHead) + portable::abs(toThird);
      sides += 2;
      turn += turnAcross(TriMesh::previous(h));
    }
    return {portable::abs(sum) / weight, length / sides};
  }

 private:
  Complex uv(HalfedgeId corner) const {
    const auto& face = map_.cornerUv[static_cast<std::size_t>(corner.i / 3)];
    const Vec2& p = map_.uv[static_cast<std::size_t>(face[static_cast<std::size_t>(corner.i % 3)])];
    return {p[0], p[1]};
  }

  /// The multiple of 2π/q by which uv vectors turn when h is crossed.
  int turnAcross(HalfedgeId h) const {
    const HalfedgeId twin = mesh_.twin(h);
    const Complex here = uv(TriMesh::next(h)) - uv(h);
    const Complex there = uv(twin) - uv(TriMesh::next(twin));
    return here == there ? 0 : measuredTurn(here, there, q_);
  }

  const TriMesh& mesh_;
  const Geometry& geometry_;
  const UvMap& map_;
  int q_;
  WeightKind kind_;
};

/// Up to the row with which more than maxViolated are violated.
HarmonicFacts factsOf(const TriMesh& mesh, const Residual& residual, const PerVertex<char>& isCone,
                      double gridStep, int maxViolated) {
  HarmonicFacts facts;
  // Both ends of a difference move by up to half a step in u and in v.
  const double rounding = std::sqrt(2.0) * gridStep;
  for (VertexId v : mesh.vertices()) {
    if (mesh.isIsolated(v) || mesh.isBoundary(v) || isCone[v]) continue;
    ++facts.rows;
    const Residual::AtVertex here = residual.at(v);
    facts.violated += !(here.residual <= kHarmonicTolerance * here.meanEdge + rounding);
    if (facts.violated > maxViolated) return facts;
    const double relative = here.meanEdge > 0 ? here.residual / here.meanEdge : 0;
    if (relative <= facts.largestResidual && facts.worst.isValid()) continue;
    facts.largestResidual = relative;
    facts.worst = v;
  }
  return facts;
}

}  // namespace

HarmonicFacts measureHarmonicity(const TriMesh& mesh, const Geometry& geometry, const UvMap& map,
                                 int q, const std::vector<VertexId>& cones, double gridStep) {
  PerVertex<char> isCone(static_cast<std::size_t>(mesh.vertexCount()), 0);
  for (VertexId v : cones) isCone[v] = 1;
  const auto with = [&](WeightKind kind, int maxViolated) {
    const Residual residual(mesh, geometry, map, q, kind);
    HarmonicFacts facts = factsOf(mesh, residual, isCone, gridStep, maxViolated);
    facts.weights = kind;
    return facts;
  };
  const HarmonicFacts meanValue = with(WeightKind::kMeanValue, mesh.vertexCount());
  if (meanValue.violated == 0) return meanValue;
  const HarmonicFacts cotangent = with(WeightKind::kCotangent, 0);
  return cotangent.violated == 0 ? cotangent : meanValue;
}

}  // namespace hgp
