#include "hgp/cones/choose_cones.h"
#include "hgp/field/read_holonomy.h"
#include "hgp/parametrize/parametrize.h"
#include "hgp/parametrize/seamless_setup.h"
#include "hgp/parametrize/stage_clock.h"

namespace hgp {

/// Required distance of cones along edges in their own metric, in cells. Less than a cell, because alignment spreads
/// close cones (decision 053) and fewer merged cones change the map less without slowing the solve (measured).
constexpr double kRoomOfCell = 0.4;
/// Maximum relative increase of the energy of the cone metric by separating cones.
constexpr double kRoomEnergy = 0.3;
/// Minimum number of quads around a vertex: a single one would share two of its edges.
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
