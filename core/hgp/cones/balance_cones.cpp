#include "hgp/cones/balance_cones.h"

#include <algorithm>

#include "hgp/base/check.h"
#include "hgp/cones/cone_placer.h"
#include "hgp/field/prepared_surface.h"

namespace hgp {
namespace {

/// Radians per edge around a vertex: no vertex is forced to take a cone.
constexpr double kAnyTurnPerEdge = 100.0;
/// Limit of nodes × solves for moving the cones that were added.
constexpr double kBalanceSolves = 3e6;

/// q·χ − Σ(q − k) − Σl over what is given.
long long missingUnits(const Topology& topology, const HolonomySpec& spec) {
  long long left = static_cast<long long>(spec.q) * topology.eulerCharacteristic;
  for (const ConePoint& cone : spec.cones) left -= spec.q - cone.k;
  for (const auto& l : spec.turning) left -= l.value_or(0);
  return left;
}

class Balancer {
 public:
  Balancer(const PreparedSurface& surface, const HolonomySpec& spec)
      : mesh_(surface.mesh()),
        context_(surface.context()),
        metric_(mesh_, context_, spec.q),
        spec_(spec),
        bounds_(defectBounds(mesh_, context_, spec.q, kAnyTurnPerEdge)),
        given_(static_cast<std::size_t>(metric_.nodeCount()), 0) {
    for (const ConePoint& cone : spec.cones)
      fix(context_.surface.node[cone.vertex], spec.q - cone.k);
    for (std::size_t j = 0; j < spec.turning.size(); ++j)
      fix(context_.surface.loopNode[j], spec.q + spec.turning[j].value_or(0));
  }

  /// The spec with the missing cones; empty if no vertex can take them.
  /// @param keepsApart  new cones share no triangle with given ones
  std::optional<HolonomySpec> place(bool keepsApart) const {
    DefectBounds bounds = bounds_;
    if (keepsApart)
      for (const ConePoint& cone : spec_.cones)
        for (const HalfedgeId h : outgoingHalfedges(mesh_, cone.vertex)) hold(bounds, h);
    ConePlacer placer(mesh_, metric_, given_, std::move(bounds));
    if (!placer.balance()) return std::nullopt;
    placer.keepCount();
    placer.setNodeSolves(kBalanceSolves);
    placer.relax();
    HolonomySpec out = spec_;
    for (const VertexId v : mesh_.vertices()) {
      if (!context_.surface.isInterior(mesh_, v)) continue;
      const auto n = static_cast<std::size_t>(context_.surface.node[v]);
      if (placer.defects()[n] != given_[n]) out.cones.push_back({v, spec_.q - placer.defects()[n]});
    }
    return out;
  }

 private:
  void fix(int node, int defect) {
    const auto n = static_cast<std::size_t>(node);
    given_[n] = bounds_.low[n] = bounds_.high[n] = defect;
  }
  /// No cone at a neighbour of a given one.
  void hold(DefectBounds& bounds, HalfedgeId h) const {
    const auto n = static_cast<std::size_t>(context_.surface.node[mesh_.head(h)]);
    bounds.low[n] = bounds.high[n] = given_[n];
  }

  const TriMesh& mesh_;
  const FieldContext& context_;
  ConeMetric metric_;
  const HolonomySpec& spec_;
  DefectBounds bounds_;
  NodeDefects given_;
};

Failure noPlace(const HolonomySpec& spec, long long left) {
  return {ErrorCode::kPrescription,
          "cones",
          formatText("cones of %lld·360°/%d are missing, and there are no vertices that can take "
                     "them besides those given",
                     left, spec.q),
          {}};
}

}  // namespace

Result<HolonomySpec> balanceCones(PreparedSurface& surface, HolonomySpec spec) {
  const TriMesh& mesh = surface.mesh();
  const Topology& topology = surface.topology();
  const bool isOpen = std::any_of(spec.turning.begin(), spec.turning.end(),
                                  [](const auto& l) { return !l.has_value(); });
  const long long left = missingUnits(topology, spec);
  const auto refusal = [&](const HolonomySpec& asked) {
    return checkPrescription(mesh, topology, asked, &surface.shortages());
  };
  if (left == 0 || isOpen) {
    const Result<BudgetReport> budget = refusal(spec);
    return budget ? Result<HolonomySpec>(std::move(spec)) : budget.error();
  }
  // What is wrong with a single cone is told before others are added.
  for (const ConePoint& cone : spec.cones) {
    const bool isThere = cone.vertex.isValid() && cone.vertex.i < mesh.vertexCount();
    if (!isThere || !surface.context().surface.isInterior(mesh, cone.vertex) || cone.k < 1)
      return refusal(spec).error();
  }
  if (Status done = surface.requireConnection(); !done) return std::move(done).error();
  const Balancer balancer(surface, spec);
  std::optional<Failure> reason;
  for (const bool keepsApart : {true, false}) {
    std::optional<HolonomySpec> placed = balancer.place(keepsApart);
    if (!placed) continue;
    const Result<BudgetReport> budget = refusal(*placed);
    if (budget) return std::move(*placed);
    reason = budget.error();
  }
  return reason ? *reason : noPlace(spec, left);
}

}  // namespace hgp
