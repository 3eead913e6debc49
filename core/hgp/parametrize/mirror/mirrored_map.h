// The map of a whole surface from that of one side of a plane.  Role: reflects coordinates bit for bit.
#pragma once

#include "hgp/mesh/reflection.h"

namespace hgp {

/// A map with one uv per copy of a vertex.
struct CopiedMap {
  UvMap map;
  std::vector<VertexId> copyOf;  ///< uv index → vertex
};

/// The map of `half`, moved and turned by a multiple of a quarter turn so that the longest of the lines that the plane consists of
/// in the map is u = 0, and its image under u ↦ −u on the other side. There both sides share their uv; across a plane edge
/// on another line u = c or v = c a seam has the translation 2c, without rotation or with one by half a turn.
/// @param side  with the bits of straight features: each edge in the plane has equal u or equal v at both ends
CopiedMap mirroredMap(const TriMesh& mesh, const Mirror& mirror, const HalfSurface& half,
                      CopiedMap side);

}  // namespace hgp
