// The sentence that says why a mesh has no map with some angles.  Role: for checks, notes and the page.
#pragma once

#include <string>

#include "hgp/mesh/angle_shortage.h"

namespace hgp {

/// "No locally injective map on this mesh has these angles: the cones 20 (k=5) and 31 (k=6) ask for …", with what to do.
std::string describeShortage(const AngleQuestion& question, const AngleShortage& shortage);

}  // namespace hgp
