#include "hgp/cones/balance_cones.h"

#include <algorithm>
#include <cstdlib>

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
    ConePlacer placer(mesh_, metric_, given_, bounds);
    if (!placer.balance()) return std::nullopt;
    placer.keepCount();
    placer.setNodeSolves(kBalanceSolves);
    placer.relax();
    const NodeDefects defects = part(placer.defects(), bounds);
    HolonomySpec out = spec_;
    for (const VertexId v : added(defects)) out.cones.push_back({v, spec_.q - defects[nodeOf(v)]});
    return out;
  }

 private:
  std::size_t nodeOf(VertexId v) const {
    return static_cast<std::size_t>(context_.surface.node[v]);
  }

  std::vector<VertexId> added(const NodeDefects& defects) const {
    std::vector<VertexId> out;
    for (const VertexId v : mesh_.vertices())
      if (context_.surface.isInterior(mesh_, v) && defects[nodeOf(v)] != given_[nodeOf(v)])
        out.push_back(v);
    return out;
  }

  /// An added cone that shares an edge with another one, which is not weaker; invalid if there is none.
  VertexId besideAnother(const NodeDefects& defects) const {
    const auto strength = [&](VertexId v) {
      return std::abs(defects[nodeOf(v)] - given_[nodeOf(v)]);
    };
    for (const VertexId v : added(defects))
      for (const HalfedgeId h : outgoingHalfedges(mesh_, v)) {
        const VertexId w = mesh_.head(h);
        if (context_.surface.isInterior(mesh_, w) && strength(w) >= strength(v)) return v;
      }
    return {};
  }

  /// Takes added cones that are side by side apart: the units of one go to where no other cone was added next to, or
  /// onto another one. Pairs stay where there is no such place.
  NodeDefects part(NodeDefects defects, const DefectBounds& bounds) const {
    for (std::size_t left = added(defects).size(); left > 0; --left) {
      const VertexId moved = besideAnother(defects);
      if (!moved.isValid()) break;
      NodeDefects start = defects;
      start[nodeOf(moved)] = given_[nodeOf(moved)];
      DefectBounds apart = bounds;
      for (const VertexId v : added(start))
        for (const HalfedgeId h : outgoingHalfedges(mesh_, v))
          if (start[nodeOf(mesh_.head(h))] == given_[nodeOf(mesh_.head(h))]) hold(apart, h);
      ConePlacer placer(mesh_, metric_, std::move(start), std::move(apart));
      if (!placer.balance()) break;
      defects = placer.defects();
    }
    return defects;
  }

  void fix(int node, int defect) {
    const auto n = static_cast<std::size_t>(node);
    given_[n] = bounds_.low[n] = bounds_.high[n] = defect;
  }
  /// No new cone at the head.
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
