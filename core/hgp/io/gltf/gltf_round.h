// uv as float32 with v from the top, chosen so that nothing certified is lost.  Role: what glTF
// stores; the certificate measures exactly this.
#pragma once

#include "hgp/mesh/mesh_data.h"

namespace hgp::io {

/// The map on a grid 2^−m on which u, v and 1 − v are all exact in float32, so that storing 1 − v
/// and reading it back gives v itself, bit for bit, and both sides of a seam are rounded alike.
///
/// Every connected component of the surface has a grid of its own: the others cost it no digits.
/// Where that turns triangles over, vertices inside the chart are moved by a few grid steps, the
/// component is moved next to the origin, and at last scaled by a power of two; the first that keeps
/// every triangle, or the best, is returned. A map that is on such a grid already comes back as it
/// is. Corners without uv (index −1) stay so.
UvMap quantizeForGltf(const MeshData& mesh, const UvMap& map);

}  // namespace hgp::io
