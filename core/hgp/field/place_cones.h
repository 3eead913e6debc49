// Cones placed for the distortion that they cause.  Role: the choice of cones by what it costs
// (optimal cones, Soliman et al. 2018), in multiples of 2π/q with Gauss–Bonnet exact.
#pragma once

#include "hgp/field/cancel_cones.h"
#include "hgp/field/cone_metric.h"

namespace hgp {

struct PlaceOptions {
  int coneCount = 0;  ///< > 0: so many cones where bounds and Gauss–Bonnet allow it
  /// Where coneCount = 0: cones are taken away while σ of log₂ area stays below `spread`, and then
  /// added, to `mostCones`, as long as that lowers the energy by kWorthwhile per quarter more.
  double spread = 0.0;
  int mostCones = 0;
  bool keepsTurning = false;                 ///< loops keep the turning they start with
  double largestTurn = kLargestTurnPerEdge;  ///< see defectBounds
  /// > 0: cones that would be closer in their own metric, in units of the surface, are merged or moved.
  double apart = 0.0;
  bool isFixed = false;  ///< cones stay where they are: only what must be is changed
  double work = 3e7;     ///< nodes × solves that may be spent
};
inline constexpr double kWorthwhile = 0.2;

/// Lowers ConeCost::energy by moving, adding, merging and cancelling units. From `start`, which need
/// not balance. Where bounds leave no place for a unit the result does not balance either.
NodeDefects placeCones(const TriMesh& mesh, const ConeMetric& metric, NodeDefects start,
                       const PlaceOptions& options);

}  // namespace hgp
