// Quads on a triangulated surface.  Role: what extraction gives and everything after it takes.
#pragma once

#include <array>
#include <vector>

#include "hgp/mesh/mesh_data.h"
#include "hgp/mesh/tri_mesh.h"

namespace hgp {

struct QuadMesh {
  std::vector<Vec3> positions;            ///< on the input surface
  std::vector<Vec3> normals;              ///< of the input surface, unit length
  std::vector<std::array<int, 4>> quads;  ///< counterclockwise
  std::vector<FaceId> face;               ///< per vertex: a face of the input surface that holds it
  std::vector<int> coneVertex;  ///< per vertex: the surface vertex of its cone, −1 elsewhere
  std::vector<char>
      isOnFeature;  ///< per vertex: on an edge that extractQuads was given, or at its end
  int clipped = 0;  ///< cells that the boundary cuts; they are left out
  /// Per vertex: how far its two coordinates are from the next multiple of four cells (0, 1 or 2), in any face's plane
  /// and thus up to their order. After two halvings: on a line of the map's own grid (0), in the middle between two
  /// such lines (2), or halfway to the middle (1).
  std::vector<std::array<std::int8_t, 2>> lines;
};

}  // namespace hgp
