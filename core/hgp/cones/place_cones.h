// Places cones so that they cause little distortion (optimal cones, Soliman et al. 2018), with angles that are
// multiples of 2π/q and exact Gauss–Bonnet.  Role: the optimisation behind automatic cones.
#pragma once

#include "hgp/cones/cancel_cones.h"
#include "hgp/cones/cone_metric.h"
#include "hgp/cones/cone_spacing.h"

namespace hgp {

struct PlaceOptions {
  int coneCount = 0;  ///< > 0: this many cones where bounds and Gauss–Bonnet allow it
  /// Where coneCount = 0: cones are removed while the standard deviation of log₂ area stays below `spread`, and then
  /// added, up to `mostCones`, as long as a quarter more of them lowers the energy by the fraction kWorthwhile.
  double spread = 0.0;
  int mostCones = 0;
  bool keepsTurning = false;                 ///< loops keep the turning they start with
  double largestTurn = kLargestTurnPerEdge;  ///< see defectBounds
  ConeSpacing spacing;                       ///< distances are those in their own metric
  bool isFixed = false;  ///< cones stay where they are, except as bounds and Gauss–Bonnet require
  double nodeSolves = 3e7;  ///< nodes × solves that may be spent
};
inline constexpr double kWorthwhile = 0.2;

/// Lowers ConeCost::energy by moving, adding, merging and cancelling units, starting from `start`, which need
/// not balance. Where the bounds leave no node for a missing unit, the result does not balance either.
NodeDefects placeCones(const TriMesh& mesh, const ConeMetric& metric, NodeDefects start,
                       const PlaceOptions& options);

}  // namespace hgp
