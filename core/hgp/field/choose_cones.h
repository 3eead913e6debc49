// Automatic cones.  Role: from a surface to a prescription that some map has, and a good one.
#pragma once

#include <optional>
#include <string_view>

#include "hgp/base/progress.h"
#include "hgp/base/result.h"
#include "hgp/field/cone_spacing.h"
#include "hgp/mesh/holonomy_spec.h"

namespace hgp {

class PreparedSurface;
struct FieldContext;

/// What cones are chosen for. All start from those of the smoothest field.
enum class ConesFor {
  kBalanced,  ///< moved, and cancelled where that helps, to lower distortion; boundaries are followed
  kFew,       ///< as few as keep σ of log₂ area below kFewSpread
  kLowDistortion,  ///< as many as are worth it; boundaries turn as they like
};
/// "balanced", "few", "low-distortion"
const char* conesForName(ConesFor choice);
std::optional<ConesFor> conesForNamed(std::string_view name);
inline constexpr double kFewSpread = 1.0;

struct SuggestOptions {
  int q = 4;
  int coneCount = 0;  ///< so many where that is possible; 0 = by `conesFor`
  ConesFor conesFor = ConesFor::kBalanced;
  bool alignToCurvature =
      false;            ///< follow principal curvature; cones then stay where that has them
  ConeSpacing spacing;  ///< for maps that are then aligned to a grid
  Progress progress;
};

/// Cones and turning; handles are left open. They pass checkPrescription, or the failure is its own:
/// no prescription of this order exists. Leaves the connection prepared.
Result<HolonomySpec> chooseCones(PreparedSurface& surface, const SuggestOptions& options);

/// What chooseCones starts from: cones and turning of the smoothest field, noise cancelled, units added or
/// taken where Gauss–Bonnet asks for it. Leaves the connection prepared.
Result<HolonomySpec> fieldCones(PreparedSurface& surface, const SuggestOptions& options);

/// Whether a closed torus is flat enough without any cone: its scale then varies by at most
/// e^kFlatScaleRange. Every torus is conformally flat, so that cones would only add distortion.
/// @param context  complete (prepareConnection)
bool isNearlyFlatTorus(const FieldContext& context);
inline constexpr double kFlatScaleRange = 1.2;

}  // namespace hgp
