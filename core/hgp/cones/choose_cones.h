// Automatic cones.  Role: from a surface to a prescription that some map has, with low distortion.
#pragma once

#include <optional>
#include <string_view>

#include "hgp/base/progress.h"
#include "hgp/base/result.h"
#include "hgp/cones/cone_spacing.h"
#include "hgp/mesh/holonomy_spec.h"

namespace hgp {

class PreparedSurface;
struct FieldContext;

/// What cones are optimised for. All choices start from the cones of the smoothest field.
enum class ConesFor {
  kBalanced,       ///< moved or cancelled where that lowers distortion; the map follows boundaries
  kFew,            ///< as few as keep the standard deviation of log₂ area below kFewSpread
  kLowDistortion,  ///< as many as lower the energy by kWorthwhile; the turning of boundaries is free
  kFewer,          ///< halfway between kFew and kBalanced in number
  kMore,           ///< halfway between kBalanced and kLowDistortion
};
/// "balanced", "few", "low-distortion", "fewer", "more"
const char* conesForName(ConesFor choice);
std::optional<ConesFor> conesForNamed(std::string_view name);
inline constexpr double kFewSpread = 1.0;

struct SuggestOptions {
  int q = 4;
  int coneCount = 0;  ///< this many where that is possible; 0: as `conesFor` says
  ConesFor conesFor = ConesFor::kBalanced;
  bool alignToCurvature =
      false;            ///< follow principal curvature; cones then stay where that has them
  ConeSpacing spacing;  ///< for maps that are then aligned to a grid
  Progress progress;
};

/// Cones and turning; handles are left open. The result passes checkPrescription. Fails with the failure of
/// checkPrescription where no prescription of this order exists. The connection of `surface` is then prepared.
Result<HolonomySpec> chooseCones(PreparedSurface& surface, const SuggestOptions& options);

/// What chooseCones starts from: cones and turning of the smoothest field after cancelCones, with units added or
/// removed until Gauss–Bonnet holds. The connection of `surface` is then prepared.
Result<HolonomySpec> fieldCones(PreparedSurface& surface, const SuggestOptions& options);

/// Whether a closed torus needs no cones: its scale without cones varies by at most
/// e^kFlatScaleRange. (Every torus is conformally flat.)
/// @param context  complete (prepareConnection)
bool isNearlyFlatTorus(const FieldContext& context);
inline constexpr double kFlatScaleRange = 1.2;

}  // namespace hgp
