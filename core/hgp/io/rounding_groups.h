// The parts of a map that are rounded independently.  Role: each has a grid of its own (round_uv.h).
#pragma once

#include <vector>

#include "hgp/mesh/mesh_data.h"

namespace hgp::io {

/// Triangles with local uv indices; `mesh` has no positions.
struct RoundingGroup {
  MeshData mesh;
  UvMap map;
  std::vector<int> uvOrigin;
  bool isFollowing = false;  ///< triangles without a part; corners of parts are −1
};

/// Every uv that a triangle uses is in exactly one group.
/// @param partOf  as in roundToFloat32
/// @pre one corner triple per triangle, indices below |uv|
std::vector<RoundingGroup> roundingGroups(const MeshData& mesh, const UvMap& map,
                                          const std::vector<int>& partOf);

}  // namespace hgp::io
