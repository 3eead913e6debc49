// The map itself as a drawing or as a flat mesh.  Role: for programs that show no texture coordinates.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "hgp/io/written.h"
#include "hgp/mesh/mesh_data.h"

namespace hgp::io {

/// Two uv that are the ends of an edge.
using UvEdge = std::array<int, 2>;

/// An SVG 1000 units large with every edge once, v upwards; `seams` in a second path, red and wider. Two
/// decimals: to look at and to print, not to measure.
Bytes uvLayoutSvg(const UvMap& map, const std::vector<UvEdge>& seams);

/// The map laid flat as an OBJ: vertices (u, v, 0) with themselves as vt.
Bytes flatObj(const UvMap& map, const std::string& generator);

}  // namespace hgp::io
