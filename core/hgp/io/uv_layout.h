// The map itself as a drawing or as a flat mesh.  Role: for programs that cannot show texture coordinates.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "hgp/io/written.h"
#include "hgp/mesh/mesh_data.h"

namespace hgp::io {

/// The uv indices of the two ends of an edge.
using UvEdge = std::array<int, 2>;

/// An SVG whose longer side is 1000 units, with every edge once and v pointing up; `seams` are a second path, red
/// and wider. Coordinates have two decimals, enough for viewing and printing but not for measuring.
Bytes uvLayoutSvg(const UvMap& map, const std::vector<UvEdge>& seams);

/// The map as a flat OBJ: vertices (u, v, 0), with (u, v) as vt.
Bytes flatObj(const UvMap& map, const std::string& generator);

}  // namespace hgp::io
