// The unknowns of a stored map on a cut that may not be its own.  Role: a drag starts from any seamless map, and starts
// again from its own frames with a new cut.
#pragma once

#include "hgp/base/result.h"
#include "hgp/parametrize/seamless_setup.h"

namespace hgp::live {

/// Develops the map over the faces of setup.cut, across the map's own seams, and reads the unknowns of the result.
/// Fails with kUsage if it does not satisfy the seam conditions of `setup` up to rounding.
/// @param map  of setup's surface, with positive triangles
Result<Eigen::VectorXcd> readMap(const TriMesh& mesh, const SeamlessSetup& setup, const UvMap& map);

}  // namespace hgp::live
