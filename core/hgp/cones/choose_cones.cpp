#include "hgp/cones/choose_cones.h"

#include <algorithm>

#include "hgp/base/parallel.h"
#include "hgp/cones/cancel_cones.h"
#include "hgp/cones/make_room.h"
#include "hgp/cones/place_cones.h"
#include "hgp/field/prepared_surface.h"
#include "hgp/field/read_holonomy.h"
#include "hgp/field/smooth_field.h"

namespace hgp {
namespace {

/// Limit of nodes × solves for balanced cones: it reaches four fifths of the gain of unlimited work in at most a
/// fifth of a run's time (docs/decisions/034, 044).
double balancedSolves(int nodes) {
  return std::max(5.0 * nodes, std::min(16.0 * nodes + 1.6e5, 1.6e6));
}
/// For few cones, beside what their removal takes (docs/decisions/113).
constexpr double kFewSolves = 1e7;
/// The limit for the other choices, which are made only on request.
constexpr double kAskedSolves = 3e7;
constexpr double kAnyTurn = 100.0;

Failure stopped() { return {ErrorCode::kCancelled, "cones", "Cancelled.", {}}; }

/// Cones and turning of the smoothest field, after noise has been cancelled. The surface then has its connection.
Result<NodeDefects> fieldDefects(PreparedSurface& surface, const SuggestOptions& options) {
  const TriMesh& mesh = surface.mesh();
  const FieldContext& context = surface.context();
  SmoothFieldOptions smooth;
  smooth.q = options.q;
  smooth.alignToCurvature = options.alignToCurvature;
  Result<FrameField> field = FrameField();
  Status connected = Done{};
  parallelInvoke({[&] { field = smoothField(mesh, context, smooth); },
                  [&] { connected = surface.requireConnection(); }});
  if (!field) return std::move(field).error();
  if (!connected) return std::move(connected).error();
  const CompleteSpec raw = specOfField(mesh, context, *field);
  PerVertex<int> defect(static_cast<std::size_t>(mesh.vertexCount()), 0);
  for (const ConePoint& cone : raw.cones) defect[cone.vertex] = options.q - cone.k;
  NodeDefects nodes(static_cast<std::size_t>(context.surface.nodeCount), 0);
  for (const ConePoint& c : cancelCones(mesh, context, options.q, std::move(defect), {}))
    nodes[static_cast<std::size_t>(context.surface.node[c.vertex])] = options.q - c.k;
  for (std::size_t j = 0; j < raw.turning.size(); ++j)
    nodes[static_cast<std::size_t>(context.surface.loopNode[j])] = options.q + raw.turning[j];
  return nodes;
}

PlaceOptions placeOptions(const SuggestOptions& options, int nodes, int cones) {
  PlaceOptions place;
  place.spacing = options.spacing;
  place.coneCount = options.coneCount;
  place.isFixed = options.alignToCurvature;
  const bool isBalanced = options.conesFor == ConesFor::kBalanced;
  place.keepsTurning = isBalanced || options.alignToCurvature;
  place.nodeSolves = isBalanced && options.coneCount == 0 ? balancedSolves(nodes) : kAskedSolves;
  if (options.coneCount > 0 || place.isFixed) return place;
  if (options.conesFor == ConesFor::kFew) {
    place.spread = kFewSpread;
    place.nodeSolves = kFewSolves;
  }
  if (options.conesFor == ConesFor::kLowDistortion) place.mostCones = 2 * cones + 8;
  return place;
}

HolonomySpec asSpec(const TriMesh& mesh, const FieldContext& context, int q,
                    const NodeDefects& defects) {
  HolonomySpec spec;
  spec.q = q;
  const auto at = [&](int node) { return defects[static_cast<std::size_t>(node)]; };
  for (VertexId v : mesh.vertices())
    if (context.surface.isInterior(mesh, v) && at(context.surface.node[v]) != 0)
      spec.cones.push_back({v, q - at(context.surface.node[v])});
  for (int loop : context.surface.loopNode) spec.turning.emplace_back(at(loop) - q);
  // A closed torus has no map with exactly one cone q − 1 and one q + 1.
  if (context.topology.genus == 1 && spec.turning.empty() && spec.cones.size() == 2 &&
      std::abs(spec.cones[0].k - q) == 1)
    spec.cones.clear();
  return spec;
}

/// The choices between which `choice` lies, if it lies between two.
std::optional<std::pair<ConesFor, ConesFor>> endsOf(ConesFor choice) {
  if (choice == ConesFor::kFewer) return std::pair(ConesFor::kFew, ConesFor::kBalanced);
  if (choice == ConesFor::kMore) return std::pair(ConesFor::kBalanced, ConesFor::kLowDistortion);
  return {};
}

/// As many cones as the mean of two choices; the second one where they hardly differ.
Result<HolonomySpec> conesBetween(PreparedSurface& surface, const SuggestOptions& options,
                                  const std::pair<ConesFor, ConesFor>& ends) {
  SuggestOptions asked = options;
  asked.conesFor = ends.first;
  const Result<HolonomySpec> one = chooseCones(surface, asked);
  if (!one) return one.error();
  asked.conesFor = ends.second;
  Result<HolonomySpec> other = chooseCones(surface, asked);
  if (!other) return other.error();
  const auto a = static_cast<int>(one->cones.size()), b = static_cast<int>(other->cones.size());
  if (std::abs(a - b) < 2) return other;
  asked.conesFor = ConesFor::kBalanced;
  asked.coneCount = (a + b + 1) / 2;
  return chooseCones(surface, asked);
}

}  // namespace

const char* conesForName(ConesFor choice) {
  static const char* const kNames[] = {"balanced", "few", "low-distortion", "fewer", "more"};
  return kNames[static_cast<int>(choice)];
}

std::optional<ConesFor> conesForNamed(std::string_view name) {
  for (const ConesFor c : {ConesFor::kBalanced, ConesFor::kFew, ConesFor::kLowDistortion,
                           ConesFor::kFewer, ConesFor::kMore})
    if (name == conesForName(c)) return c;
  return {};
}

Result<HolonomySpec> chooseCones(PreparedSurface& surface, const SuggestOptions& options) {
  const TriMesh& mesh = surface.mesh();
  const Topology& topology = surface.topology();
  if (const auto ends = endsOf(options.conesFor); ends && options.coneCount == 0)
    return conesBetween(surface, options, *ends);
  // On a sphere there are no cones for q = 1: this must be reported before any are chosen.
  if (topology.genus == 0 && topology.loops.empty() && options.q == 1)
    return checkPrescription(mesh, topology, {1, {}, {}, {}}).error();
  if (!report(options.progress, {Stage::kCones, 0.3})) return stopped();
  Result<NodeDefects> start = fieldDefects(surface, options);
  if (!start) return std::move(start).error();
  if (!report(options.progress, {Stage::kCones, 0.6})) return stopped();
  const FieldContext& context = surface.context();
  const ConeMetric metric(mesh, context, options.q);
  PlaceOptions place = placeOptions(options, metric.nodeCount(), coneCount(mesh, context, *start));
  const auto placed = [&] {
    HolonomySpec spec = asSpec(mesh, context, options.q, placeCones(mesh, metric, *start, place));
    makeRoom(mesh, spec, surface.shortages());
    return spec;
  };
  HolonomySpec spec = placed();
  Result<BudgetReport> budget = checkPrescription(mesh, topology, spec, &surface.shortages());
  if (!budget && place.keepsTurning) {
    // With the field's turning, interior vertices cannot take all units (q = 1 on a disk).
    place.keepsTurning = false;
    spec = placed();
    budget = checkPrescription(mesh, topology, spec, &surface.shortages());
  }
  if (!budget) {
    // For small q even one unit turns frames by more than the usual limit (q = 1, genus 2).
    place.largestTurn = kAnyTurn;
    spec = placed();
    budget = checkPrescription(mesh, topology, spec, &surface.shortages());
  }
  if (!budget) return std::move(budget).error();
  if (!report(options.progress, {Stage::kCones, 0.8})) return stopped();
  return spec;
}

Result<HolonomySpec> fieldCones(PreparedSurface& surface, const SuggestOptions& options) {
  Result<NodeDefects> start = fieldDefects(surface, options);
  if (!start) return std::move(start).error();
  const TriMesh& mesh = surface.mesh();
  const FieldContext& context = surface.context();
  PlaceOptions place;
  place.isFixed = place.keepsTurning = true;
  const NodeDefects placed = placeCones(mesh, ConeMetric(mesh, context, options.q), *start, place);
  HolonomySpec spec = asSpec(mesh, context, options.q, placed);
  Result<BudgetReport> budget =
      checkPrescription(mesh, surface.topology(), spec, &surface.shortages());
  if (!budget) return std::move(budget).error();
  return spec;
}

bool isNearlyFlatTorus(const FieldContext& context) {
  if (context.topology.genus != 1 || !context.topology.loops.empty()) return false;
  const std::vector<double>& K = context.surface.curvature;
  Eigen::VectorXd gap = -Eigen::Map<const Eigen::VectorXd>(K.data(), context.surface.nodeCount);
  gap.array() -= gap.mean();
  const Eigen::VectorXd u = context.laplacian.solve(gap);
  return u.maxCoeff() - u.minCoeff() <= kFlatScaleRange;
}

}  // namespace hgp
