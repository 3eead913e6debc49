// Straight walks on the surface.  Role: moves vertices of quads along it.
#pragma once

#include <array>
#include <optional>

#include "hgp/mesh/mesh_data.h"
#include "hgp/mesh/tri_mesh.h"

namespace hgp {

struct SurfacePoint {
  FaceId face;
  Vec3 position{}, normal{};  ///< the normal is that of the face, unit length
};

/// From `start` straight on over edges, as if the triangles were unfolded into the plane of its face.
/// @param direction  unit vector in that plane; its first axis runs from corner 0 to corner 1
/// Nothing where the walk leaves the surface, meets a triangle without area, or crosses too many triangles.
std::optional<SurfacePoint> walkStraight(const TriMesh& mesh, const SurfacePoint& start,
                                         const std::array<double, 2>& direction, double length);

}  // namespace hgp
