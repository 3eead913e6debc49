#include "hgp/cones/balance_cones.h"

#include <algorithm>
#include <cstdlib>
#include <set>

#include "hgp/base/check.h"
#include "hgp/cones/cancel_cones.h"
#include "hgp/cones/choose_cones.h"
#include "hgp/cones/cone_placer.h"
#include "hgp/field/prepared_surface.h"

namespace hgp {
namespace {

/// Radians per edge around a vertex: no vertex is forced to take a cone.
constexpr double kAnyTurnPerEdge = 100.0;
/// Limits of nodes × solves for moving cones that were added one by one, and those of the field, as chooseCones has it.
constexpr double kBalanceSolves = 3e6;
constexpr double kFieldSolves = 3e7;
/// Places for a cone that stands beside another one, each of which is a solve.
constexpr std::size_t kPlaces = 12;

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

  /// The spec with the missing cones; empty if no vertex can take them. They are placed one by one, and the cones of the
  /// field are reduced to as many: the distortion decides.
  /// @param keepsApart  new cones share no triangle with given ones
  /// @param field  cones of the smoothest field, if there are any
  std::optional<HolonomySpec> place(bool keepsApart, const HolonomySpec* field) const {
    const DefectBounds bounds = keepsApart ? apart(bounds_) : bounds_;
    std::optional<NodeDefects> best = oneByOne(bounds);
    if (!best) return std::nullopt;
    if (field != nullptr) {
      const std::optional<NodeDefects> other = reduced(*field, bounds, countOf(*best));
      if (other && energy(*other) < energy(*best)) best = other;
    }
    HolonomySpec out = spec_;
    for (const VertexId v : added(*best)) out.cones.push_back({v, spec_.q - (*best)[nodeOf(v)]});
    return out;
  }

 private:
  std::optional<NodeDefects> oneByOne(const DefectBounds& bounds) const {
    ConePlacer placer(mesh_, metric_, given_, bounds);
    if (!placer.balance()) return std::nullopt;
    placer.keepCount();
    placer.setNodeSolves(kBalanceSolves);
    placer.relax();
    return part(placer.defects(), bounds);
  }

  /// The cones of a field, as far as those given leave room for them, reduced to `count` in all where that is possible.
  std::optional<NodeDefects> reduced(const HolonomySpec& field, DefectBounds bounds,
                                     int count) const {
    const DefectBounds usual = defectBounds(mesh_, context_, spec_.q, kLargestTurnPerEdge);
    NodeDefects start(given_.size(), 0);
    for (const ConePoint& cone : field.cones) start[nodeOf(cone.vertex)] = spec_.q - cone.k;
    for (std::size_t n = 0; n < start.size(); ++n) {
      const bool isHeld = bounds.low[n] == bounds.high[n];
      if (!isHeld) bounds.low[n] = usual.low[n], bounds.high[n] = usual.high[n];
      start[n] = std::clamp(start[n], bounds.low[n], bounds.high[n]);
    }
    ConePlacer placer(mesh_, metric_, std::move(start), bounds);
    if (!placer.balance()) return std::nullopt;
    placer.setNodeSolves(kFieldSolves);
    placer.keepCount();
    placer.growTo(count);
    placer.shrinkTo(count);
    placer.relax();
    return part(placer.defects(), bounds);
  }

  DefectBounds apart(DefectBounds bounds) const {
    for (const ConePoint& cone : spec_.cones)
      for (const HalfedgeId h : outgoingHalfedges(mesh_, cone.vertex)) hold(bounds, h);
    return bounds;
  }
  int countOf(const NodeDefects& defects) const { return coneCount(mesh_, context_, defects); }
  double energy(const NodeDefects& defects) const { return metric_.cost(defects).energy; }
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

  /// The vertices nearest to `v`, by edges, that may take `units` and have no added cone at or next to them.
  std::vector<VertexId> placesNear(VertexId v, int units, const NodeDefects& defects,
                                   const DefectBounds& bounds) const {
    const auto isPlain = [&](VertexId w) {
      return !context_.surface.isInterior(mesh_, w) || defects[nodeOf(w)] == given_[nodeOf(w)];
    };
    const auto takes = [&](VertexId w) {
      if (!context_.surface.isInterior(mesh_, w) || !isPlain(w)) return false;
      const int d = given_[nodeOf(w)] + units;
      if (d < bounds.low[nodeOf(w)] || d > bounds.high[nodeOf(w)]) return false;
      for (const HalfedgeId h : outgoingHalfedges(mesh_, w))
        if (!isPlain(mesh_.head(h))) return false;
      return true;
    };
    std::vector<VertexId> reached = {v}, found;
    std::set<VertexId> seen = {v};
    for (std::size_t i = 0; i < reached.size() && found.size() < kPlaces; ++i) {
      if (takes(reached[i])) found.push_back(reached[i]);
      for (const HalfedgeId h : outgoingHalfedges(mesh_, reached[i]))
        if (seen.insert(mesh_.head(h)).second) reached.push_back(mesh_.head(h));
    }
    return found;
  }

  /// Takes added cones that are side by side apart: one moves a few edges, or its units go wherever they distort least.
  /// Pairs stay where there is no such place.
  NodeDefects part(NodeDefects defects, const DefectBounds& bounds) const {
    for (std::size_t left = added(defects).size(); left > 0; --left) {
      const VertexId moved = besideAnother(defects);
      if (!moved.isValid()) break;
      NodeDefects start = defects;
      const int units = start[nodeOf(moved)] - given_[nodeOf(moved)];
      start[nodeOf(moved)] = given_[nodeOf(moved)];
      DefectBounds apart = bounds;
      for (const VertexId v : added(start))
        for (const HalfedgeId h : outgoingHalfedges(mesh_, v))
          if (start[nodeOf(mesh_.head(h))] == given_[nodeOf(mesh_.head(h))]) hold(apart, h);
      std::optional<NodeDefects> best;
      const auto offer = [&](NodeDefects other) {
        if (!best || energy(other) < energy(*best)) best = std::move(other);
      };
      for (const VertexId v : placesNear(moved, units, start, bounds)) {
        NodeDefects other = start;
        other[nodeOf(v)] += units;
        offer(std::move(other));
      }
      ConePlacer placer(mesh_, metric_, std::move(start), std::move(apart));
      if (placer.balance()) offer(placer.defects());
      if (!best) break;
      defects = *best;
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
  SuggestOptions ofField;
  ofField.q = spec.q;
  const Result<HolonomySpec> field = fieldCones(surface, ofField);
  std::optional<Failure> reason;
  for (const bool keepsApart : {true, false}) {
    std::optional<HolonomySpec> placed = balancer.place(keepsApart, field ? &*field : nullptr);
    if (!placed) continue;
    const Result<BudgetReport> budget = refusal(*placed);
    if (budget) return std::move(*placed);
    reason = budget.error();
  }
  return reason ? *reason : noPlace(spec, left);
}

}  // namespace hgp
