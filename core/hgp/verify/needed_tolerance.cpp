#include "hgp/verify/needed_tolerance.h"

#include <algorithm>

#include "hgp/base/turns.h"

namespace hgp {

NeededTolerance neededTolerance(const Certificate& c) {
  NeededTolerance out{c.seams.largestRelativeResidual, c.angles.worstDistance, false};
  bool isAsAsked = true, isCertain = true;
  for (const MeasuredTurning& t : c.angles.turnings) {
    out.angle = std::max(out.angle, t.distance);
    isAsAsked = isAsAsked && t.asked.value_or(t.measured) == t.measured;
  }
  for (const MeasuredCone& k : c.angles.wrong) isAsAsked = isAsAsked && k.asked == k.measured;
  for (const MeasuredSeam& s : c.seams.broken) isCertain = isCertain && s.hasRotation;
  const bool isTolerance = std::all_of(c.reasons.begin(), c.reasons.end(), [](const Reason& r) {
    return r.rule == Rule::kSeam || r.rule == Rule::kConeAngle || r.rule == Rule::kTurning ||
           r.rule == Rule::kRange;
  });
  const bool isNear = out.angle <= turnAngle(kLargestAngleAllowance, std::max(c.q, 1));
  out.isSufficient = c.isUsable && isAsAsked && isCertain && isTolerance && isNear;
  return out;
}

NeededTolerance neededTolerance(const std::vector<Certificate>& components) {
  NeededTolerance out{0, 0, !components.empty()};
  for (const Certificate& c : components) {
    const NeededTolerance here = neededTolerance(c);
    out = {std::max(out.seam, here.seam), std::max(out.angle, here.angle),
           out.isSufficient && here.isSufficient};
  }
  return out;
}

}  // namespace hgp
