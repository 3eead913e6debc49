// Lengths of feature edges alone.  Role: whether, and where, the lengths of straight features contradict each other; cheap
// enough to be asked of many fields.
#pragma once

#include "hgp/optimize/straight_program.h"

namespace hgp {

struct LengthFit {
  double excess = 0.0;  ///< min over x of Σ max(0, 1 − g_e(x))², and 1 more for every flat triangle
  bool isPossible = false;        ///< all g_e are positive there, and no triangle is flat
  std::vector<HalfedgeId> edges;  ///< that are short there, the shortest first; empty if none is
  std::vector<FaceId> flat;       ///< all three corners have the same u, or the same v, for all x
};

/// g_e(x) is the signed length of edge e in the map over its length on the surface, a sum of real unknowns x. The least
/// excess is 0 if and only if some x gives every edge a positive length: the condition has no other scale. The
/// shortfalls max(0, 1 − g_e) at the minimum are a Farkas certificate otherwise: Σ_e shortfall_e g_e = 0 identically.
/// A triangle is flat where a cone and a corner, or vertices of one line, have equal rows.
/// Distances of cones from sides (StraightSystem::distances) are lengths, too, and are listed by the first edge of the side.
LengthFit fitLengths(const StraightSystem& straight);

}  // namespace hgp
