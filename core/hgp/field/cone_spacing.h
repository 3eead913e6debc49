// What a grid asks of automatic cones.  Role: passed on from who asks for a grid to who places cones.
#pragma once

namespace hgp {

struct ConeSpacing {
  /// > 0: no two cones are closer in the map that they will have, in units of the surface; whatever else is
  /// asked, those that are get merged or moved.
  double least = 0.0;
  /// What that may add to the energy, as a share of it: cones that crowd a spike keep its scale bearable.
  double dearest = 0.0;
  /// No cone has a smaller k where the curvature of its vertex allows that.
  int smallestK = 1;
};

}  // namespace hgp
