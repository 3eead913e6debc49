#include "hgp/field/choose_cones.h"
#include "hgp/field/read_holonomy.h"
#include "hgp/parametrize/parametrize.h"
#include "hgp/parametrize/seamless_setup.h"
#include "hgp/parametrize/stage_clock.h"

namespace hgp {

/// Cells apart along edges in their own metric: in the map it may be a quarter less. In quad mode cones closer
/// than a cell almost always fold, and are worth more energy (both measured, decision 038).
ConeSpacing roomForGrid(double spacing, GridMode mode) {
  return mode == GridMode::kQuad ? ConeSpacing{1.6 * spacing, 0.6}
                                 : ConeSpacing{1.3 * spacing, 0.3};
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
