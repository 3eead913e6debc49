// The smallest tolerance that a map would pass.  Role: advice of `verify` for files that were printed with few digits.
#pragma once

#include <vector>

#include "hgp/verify/certificate.h"

namespace hgp {

/// The smallest CertifyOptions::tolerance that the seams and the angles of this map would pass, each.
struct NeededTolerance {
  double seam = 0;            ///< of the edge's own length; infinite where an edge has none
  double angle = 0;           ///< radians
  bool isSufficient = false;  ///< with the larger one every rule holds
};
NeededTolerance neededTolerance(const Certificate& certificate);
/// Of all components together.
NeededTolerance neededTolerance(const std::vector<Certificate>& components);

}  // namespace hgp
