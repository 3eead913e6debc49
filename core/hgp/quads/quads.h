// The quad mesh of an aligned map.  Role: transfers grid points, unit edges and cells of the plane to the
// surface, in exact integer arithmetic.
#pragma once

#include "hgp/base/result.h"
#include "hgp/mesh/mesh_data.h"
#include "hgp/quads/quad_mesh.h"

namespace hgp {

/// Maximum number of quads; each needs about 600 bytes while they are extracted.
inline constexpr int kMaxQuads = 3'000'000;

/// Extracts the unit grid of a map for q = 2 or 4 whose translations and cones are Gaussian integers
/// and whose coordinates are multiples of one power of two. Every vertex is a grid point on the
/// surface, once however many triangles meet there. From it one unit edge leaves in every direction of its
/// total angle, walked triangle by triangle through seams; faces turn left four times.
///
/// `halvings`: how often cells are cut into four, that is, the grid of 2^halvings times the map.
///
/// `features`: edges whose vertices in the quad mesh are marked (QuadMesh::isOnFeature).
///
/// Closed surfaces: only quads, as many as that map's area, V − E + F = χ, valence k at a cone.
/// Fails with kUnsupported, the rule and the place where the map is not such a grid.
/// Fails with kLimit above kMaxQuads.
Result<QuadMesh> extractQuads(const TriMesh& mesh, const UvMap& map, int q, int halvings = 0,
                              const std::vector<EdgeId>& features = {});

}  // namespace hgp
