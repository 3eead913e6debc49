#include "hgp/cones/place_cones.h"

#include <algorithm>

#include "hgp/cones/cone_placer.h"

namespace hgp {

namespace {

/// Removes cones while the standard deviation of log₂ area stays below `spread`: a quarter of them at a time, then fewer.
/// Those that are left settle after each step, and are moved one by one only where that decides or at the end.
void shrinkWithin(ConePlacer& placer, double spread) {
  constexpr int kFirstPart = 4, kLastPart = 16;
  const auto isWithin = [&] { return areaSpread(placer.cost().scale) <= spread; };
  placer.settle();
  for (int part = kFirstPart; placer.cones() > 1;) {
    const ConePlacer before = placer;
    const int step = std::max(1, placer.cones() / part);
    placer.thinTo(placer.cones() - step);
    const bool isFewer = placer.cones() < before.cones();
    if (isFewer) placer.settle();
    if (isFewer && !isWithin()) placer.relax(0.5);
    if (isFewer && isWithin()) continue;
    placer.restore(before);
    if (step == 1 || part >= kLastPart) break;
    part *= 2;
  }
  placer.relax();
}

/// Adds cones, up to `most`, while a quarter more of them lowers the energy by the fraction kWorthwhile.
void growWhileWorthwhile(ConePlacer& placer, int most) {
  while (placer.cones() < most) {
    const ConePlacer before = placer;
    placer.growTo(std::min(most, placer.cones() + std::max(2, placer.cones() / 4)));
    if (placer.cost().energy < (1.0 - kWorthwhile) * before.cost().energy) continue;
    placer.restore(before);
    return;
  }
}

/// Requires k ≥ smallestK at vertices whose curvature allows it, and lowers their initial defects accordingly.
void raiseSmallestK(const TriMesh& mesh, const ConeMetric& metric, int smallestK,
                    DefectBounds& bounds, NodeDefects& defects) {
  const FilledSurface& surface = metric.context().surface;
  for (VertexId v : mesh.vertices()) {
    if (!surface.isInterior(mesh, v)) continue;
    const auto at = static_cast<std::size_t>(surface.node[v]);
    bounds.high[at] = std::max(bounds.low[at], std::min(bounds.high[at], metric.q() - smallestK));
    defects[at] = std::min(defects[at], bounds.high[at]);
  }
}

}  // namespace

NodeDefects placeCones(const TriMesh& mesh, const ConeMetric& metric, NodeDefects start,
                       const PlaceOptions& options) {
  DefectBounds bounds = defectBounds(mesh, metric.context(), metric.q(), options.largestTurn);
  for (const int loop : metric.context().surface.loopNode) {
    const auto at = static_cast<std::size_t>(loop);
    if (options.keepsTurning) bounds.low[at] = bounds.high[at] = start[at];
  }
  if (options.spacing.smallestK > 1)
    raiseSmallestK(mesh, metric, options.spacing.smallestK, bounds, start);
  ConePlacer placer(mesh, metric, std::move(start), std::move(bounds));
  if (!placer.balance()) return placer.defects();
  placer.setNodeSolves(options.isFixed ? 0.0 : options.nodeSolves);
  if (options.coneCount > 0) {
    placer.keepCount();
    placer.growTo(options.coneCount);
    placer.shrinkTo(options.coneCount);
  }
  if (options.spread > 0.0)
    shrinkWithin(placer, options.spread);
  else
    placer.relax();
  if (options.mostCones > 0) growWhileWorthwhile(placer, options.mostCones);
  if (options.spacing.least > 0.0) placer.separate(options.spacing);
  return placer.defects();
}

}  // namespace hgp
