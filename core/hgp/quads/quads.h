// The quad mesh of an aligned map.  Role: transfers grid points, unit edges and cells of the plane to the
// surface, in exact integer arithmetic.
#pragma once

#include <array>
#include <vector>

#include "hgp/base/result.h"
#include "hgp/mesh/mesh_data.h"
#include "hgp/mesh/tri_mesh.h"

namespace hgp {

/// Maximum number of quads; each needs about 600 bytes while they are extracted.
inline constexpr int kMaxQuads = 3'000'000;

struct QuadMesh {
  std::vector<Vec3> positions;            ///< on the input surface
  std::vector<Vec3> normals;              ///< of the input surface, unit length
  std::vector<std::array<int, 4>> quads;  ///< counterclockwise
  std::vector<FaceId> face;               ///< per vertex: a face of the input surface that holds it
  std::vector<int> coneVertex;  ///< per vertex: the surface vertex of its cone, −1 elsewhere
  int clipped = 0;              ///< cells that the boundary cuts; they are left out
  /// Per vertex: how far its two coordinates are from the next multiple of four cells (0, 1 or 2), in any face's plane
  /// and thus up to their order. After two halvings: on a line of the map's own grid (0), in the middle between two
  /// such lines (2), or halfway to the middle (1).
  std::vector<std::array<std::int8_t, 2>> lines;
};

/// Extracts the unit grid of a map for q = 2 or 4 whose translations and cones are Gaussian integers
/// and whose coordinates are multiples of one power of two. Every vertex is a grid point on the
/// surface, once however many triangles meet there. From it one unit edge leaves in every direction of its
/// total angle, walked triangle by triangle through seams; faces turn left four times.
///
/// `halvings`: how often cells are cut into four, that is, the grid of 2^halvings times the map.
///
/// Closed surfaces: only quads, as many as that map's area, V − E + F = χ, valence k at a cone.
/// Fails with kUnsupported, the rule and the place where the map is not such a grid.
/// Fails with kLimit above kMaxQuads.
Result<QuadMesh> extractQuads(const TriMesh& mesh, const UvMap& map, int q, int halvings = 0);

}  // namespace hgp
