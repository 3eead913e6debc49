// Ways in the unfolded map.  Role: the distance from one copy to another along an axis, across seams, as a sum of real unknowns.
#pragma once

#include <vector>

#include "hgp/features/real_unknowns.h"
#include "hgp/features/sum_relations.h"

namespace hgp {

/// A seam edge that a way crosses: one of its vertices in the charts of both sides, and the way's direction in both, in quarter
/// turns from the u axis.
struct SeamStep {
  int copyBefore, copyAfter;
  int before, after;
};

/// Part `part` (0 real, 1 imaginary) of a copy, in unknowns.
RealSum partOf(const RealUnknowns& unknowns, int copy, int part);
/// Adds factor · Re(i^−direction z_copy).
void addAlong(RealSum& sum, const RealUnknowns& unknowns, int copy, int direction, double factor);
/// Re(i^−direction (z_to − z_from)) in the chart of `from`, with z_to unfolded over the steps.
RealSum wayAlong(const RealUnknowns& unknowns, int from, int direction,
                 const std::vector<SeamStep>& steps, int to);

}  // namespace hgp
