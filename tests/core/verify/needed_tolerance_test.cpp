// The tolerance that a map would need.  Laws: it is sufficient exactly where nothing but a tolerance is missing, and for
// several components where it is for each.
#include "hgp/verify/needed_tolerance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "hgp/base/turns.h"

namespace hgp {
namespace {

/// A certificate with seams and angles that are off, and as they are asked for.
Certificate coarse() {
  Certificate c;
  c.q = 4;
  c.isUsable = true;
  c.seams.largestRelativeResidual = 3e-4;
  c.seams.broken.resize(1);
  c.seams.broken[0].hasRotation = true;
  c.angles.worstDistance = 2e-5;
  c.angles.wrong.resize(1);
  c.angles.wrong[0].asked = c.angles.wrong[0].measured = 3;
  c.angles.turnings.resize(2);
  c.angles.turnings[0].distance = 1e-5;
  c.angles.turnings[0].asked = c.angles.turnings[0].measured = -4;
  c.angles.turnings[1].distance = 5e-5;  // what is not asked is as measured
  for (const Rule rule : {Rule::kSeam, Rule::kConeAngle, Rule::kTurning, Rule::kRange}) {
    c.reasons.emplace_back();
    c.reasons.back().rule = rule;
  }
  return c;
}

TEST(NeededTolerance, IsTheLargestOfItsKind) {
  const NeededTolerance needed = neededTolerance(coarse());
  EXPECT_EQ(needed.seam, 3e-4);
  EXPECT_EQ(needed.angle, 5e-5);
  EXPECT_TRUE(needed.isSufficient);
}

TEST(NeededTolerance, IsNotSufficientWhereSomethingElseIsWrong) {
  const std::vector<std::function<void(Certificate&)>> changes{
      [](Certificate& c) { c.isUsable = false; },
      [](Certificate& c) { c.angles.wrong[0].measured = 4; },
      [](Certificate& c) { c.angles.turnings[0].measured = -3; },
      [](Certificate& c) { c.seams.broken[0].hasRotation = false; },
      [](Certificate& c) { c.reasons.front().rule = Rule::kOrientation; }};
  for (std::size_t n = 0; n < changes.size(); ++n) {
    Certificate c = coarse();
    changes[n](c);
    EXPECT_FALSE(neededTolerance(c).isSufficient) << n;
  }
}

TEST(NeededTolerance, ReachesToAQuarterOfATurnByOneStep) {
  // The largest that certification accepts, whatever q.
  for (const int q : {1, 3, 4, 6}) {
    Certificate c = coarse();
    c.q = q;
    c.angles.worstDistance = turnAngle(kLargestAngleAllowance, q);
    EXPECT_TRUE(neededTolerance(c).isSufficient) << q;
    c.angles.worstDistance = std::nextafter(c.angles.worstDistance, 10.0);
    EXPECT_FALSE(neededTolerance(c).isSufficient) << q;
  }
}

TEST(NeededTolerance, OfComponentsIsTheLargestAndSufficientForAll) {
  Certificate other = coarse();
  other.seams.largestRelativeResidual = 1e-6;
  other.angles.worstDistance = 7e-5;
  const NeededTolerance both = neededTolerance(std::vector{coarse(), other});
  EXPECT_EQ(both.seam, 3e-4);
  EXPECT_EQ(both.angle, 7e-5);
  EXPECT_TRUE(both.isSufficient);
  other.isUsable = false;
  EXPECT_FALSE(neededTolerance(std::vector{coarse(), other}).isSufficient);
  EXPECT_FALSE(neededTolerance(std::vector{other, coarse()}).isSufficient);
  EXPECT_FALSE(neededTolerance(std::vector<Certificate>{}).isSufficient);
}

}  // namespace
}  // namespace hgp
