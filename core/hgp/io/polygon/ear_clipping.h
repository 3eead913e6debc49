// The triangles of one polygon.  Role: ear clipping; which diagonals a mesh can take is decided by triangulate().
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "hgp/mesh/mesh_data.h"

namespace hgp::io {

/// Maximum of point-in-triangle tests for a whole document; ordinary files need a few per corner.
inline constexpr std::int64_t kMaxEarTests = 400'000'000;

/// Subtracted from the score of an ear, which is the sine of its smallest angle (at most √3/2) where the ear is valid.
struct DiagonalCosts {
  std::function<double(int, int)> of;  ///< of the diagonal between two corners of the polygon
  double ofInvalid = 0;                ///< of an ear that is reflex or contains another corner
};

/// Ear clipping in the plane of the polygon's Newell normal; the ear with the largest score is cut first. A polygon
/// of n corners gives n − 2 triangles of corner numbers, in the polygon's orientation. Of two diagonals of a quadrilateral
/// that are equally good, as those of a rectangle are, the one with the corner farthest from the centre is taken, then the
/// farthest along x, y and z: quadrilaterals that mirror each other across a plane through the centre have mirrored
/// diagonals. `tests` counts up; the caller compares it with kMaxEarTests.
/// @param centre  of the whole mesh
std::vector<std::array<int, 3>> clipEars(const std::vector<Vec3>& polygon, const Vec3& centre,
                                         std::int64_t& tests, const DiagonalCosts* costs = nullptr);

}  // namespace hgp::io
