// Rounds uv to float32 so that the map stays certified.  Role: glTF, which measures v from the top, and PLY store these
// values, and the certificate is measured on them.
#pragma once

#include "hgp/mesh/mesh_data.h"

namespace hgp::io {

/// The map rounded to a grid 2^−m on which u, v and 1 − v are exact in float32, so that storing 1 − v
/// and reading it back gives v, bit for bit, and both sides of a seam are rounded alike.
///
/// Every part has its own grid, so that its precision does not depend on the others. Triangles whose part is −1 take
/// uv of the parts, and what they have besides is rounded apart. Without parts, each connected component is one;
/// parts that share a uv are rounded as one.
/// If rounding flips triangles, vertices inside the chart are moved by a few grid steps, then the
/// component is moved to the origin, and finally scaled by a power of two; the first candidate that keeps
/// every triangle positive, or else the best one, is returned. A map that is already on such a grid is returned
/// unchanged. Corners without uv (index −1) keep −1.
/// @param partOf  part of every triangle; empty: found by connectivity
UvMap roundToFloat32(const MeshData& mesh, const UvMap& map, const std::vector<int>& partOf = {});

}  // namespace hgp::io
