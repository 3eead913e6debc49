// Cones placed for the distortion that they cause.  Role: the choice of cones by what it costs
// (optimal cones, Soliman et al. 2018), in multiples of 2π/q with Gauss–Bonnet exact.
#pragma once

#include "hgp/field/cancel_cones.h"
#include "hgp/field/cone_metric.h"
#include "hgp/field/cone_spacing.h"

namespace hgp {

struct PlaceOptions {
  int coneCount = 0;  ///< > 0: so many cones where bounds and Gauss–Bonnet allow it
  /// Where coneCount = 0: cones are taken away while σ of log₂ area stays below `spread`, and then
  /// added, to `mostCones`, as long as that lowers the energy by kWorthwhile per quarter more.
  double spread = 0.0;
  int mostCones = 0;
  bool keepsTurning = false;                 ///< loops keep the turning they start with
  double largestTurn = kLargestTurnPerEdge;  ///< see defectBounds
  ConeSpacing spacing;                       ///< distances are those in their own metric
  bool isFixed = false;  ///< cones stay where they are: only what must be is changed
  double work = 3e7;     ///< nodes × solves that may be spent
};
inline constexpr double kWorthwhile = 0.2;

/// Lowers ConeCost::energy by moving, adding, merging and cancelling units. From `start`, which need
/// not balance. Where bounds leave no place for a unit the result does not balance either.
NodeDefects placeCones(const TriMesh& mesh, const ConeMetric& metric, NodeDefects start,
                       const PlaceOptions& options);

}  // namespace hgp
