// What a grid requires of automatic cones.  Role: an option of cone placement that depends on the grid.
#pragma once

namespace hgp {

struct ConeSpacing {
  /// > 0: minimum distance of two cones in the map that they will have, in units of the surface. Cones that are closer
  /// are merged or moved, whatever the other options say.
  double least = 0.0;
  /// Maximum relative increase of the energy by separation: several cones on a spike can be needed for its scale.
  double dearest = 0.0;
  /// Minimum k of a cone, where the curvature of its vertex allows it.
  int smallestK = 1;
};

}  // namespace hgp
