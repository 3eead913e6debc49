#include "hgp/field/choose_cones.h"
#include "hgp/field/read_holonomy.h"
#include "hgp/parametrize/parametrize.h"
#include "hgp/parametrize/seamless_setup.h"
#include "hgp/parametrize/stage_clock.h"

namespace hgp {

/// Of a cell, how far apart along edges in their own metric: alignment spreads cones that are closer than a cell
/// (decision 053), and merging few cones changes the map less and keeps its solve as short (both measured).
constexpr double kRoomOfCell = 0.4;
/// Of the energy of the cone metric, what making room may add.
constexpr double kRoomEnergy = 0.3;
/// Around a vertex: a quad that is alone there meets itself.
constexpr int kMinQuads = 2;

ConeSpacing roomForGrid(double spacing, GridMode mode, int q) {
  const bool isForQuads = mode == GridMode::kQuad;
  return {kRoomOfCell * spacing, kRoomEnergy, isForQuads ? kMinQuads * q / 4 : 1};
}

Result<CompleteSpec> suggestCones(PreparedSurface& surface, const SuggestOptions& options,
                                  std::vector<StageTime>* times) {
  std::vector<StageTime> unused;
  StageClock clock(options.progress, times != nullptr ? *times : unused);
  if (!clock.begin(Stage::kCones)) return clock.cancelled();
  Result<HolonomySpec> spec = chooseCones(surface, options);
  if (!spec) return std::move(spec).error();
  if (!clock.begin(Stage::kConnection)) return clock.cancelled();
  if (Status done = surface.requireConnection(); !done) return std::move(done).error();
  if (options.coneCount == 0 && isNearlyFlatTorus(surface.context())) spec->cones.clear();
  Result<PrescribedField> completed = surface.field(*spec);
  if (!completed) return std::move(completed).error();
  return completed->spec;
}

Result<CompleteSpec> suggestCones(const TriMesh& mesh, const SuggestOptions& options) {
  PreparedSurface surface(mesh);
  return suggestCones(surface, options);
}

Result<CompleteSpec> readHolonomy(const TriMesh& mesh, const FieldData& field,
                                  const std::vector<ConePoint>& expected) {
  Result<FieldContext> context = prepareFields(mesh);
  if (!context) return std::move(context).error();
  return specOfFieldData(mesh, *context, field, expected);
}

}  // namespace hgp
