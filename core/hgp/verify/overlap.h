// How much of a map overlaps itself.  Role: reported only; local injectivity allows distant parts to overlap.
#pragma once

#include "hgp/mesh/mesh_data.h"

namespace hgp {

struct OverlapFacts {
  double share = 0.0;  ///< part of the covered plane that more than one triangle covers, 0 to 1
  int layers = 0;      ///< most triangles over one point
};

/// Counted at the centres of a size × size grid over the map's bounding square, so that parts thinner
/// than a cell may be missed. A centre on an edge that two triangles share counts once. O(|F| + what
/// the triangles cover). Triangles with an index out of range or a uv that is not finite are left out.
OverlapFacts measureOverlap(const UvMap& map, int size = 512);

}  // namespace hgp
