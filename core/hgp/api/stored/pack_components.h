// Arranges the components of a map side by side.  Role: far from the origin fewer digits of a coordinate are left
// for a triangle's shape, so small components stay near the origin.
#pragma once

#include <vector>

#include "hgp/mesh/box.h"
#include "hgp/mesh/mesh_data.h"

namespace hgp::api {

using UvBox = Box<2>;

/// One shift per box, such that no two boxes overlap and together they roughly fill a square with one corner at
/// the origin: by increasing size, in strips that are added alternately on the right and on top. A box of
/// size s lies within O(√(Σ areas of smaller boxes) + s) of the origin. Every shift is a
/// multiple of a power of two that is at least 1/32 of the box, or of `unit` if that is larger, so that
/// coordinates on a grid stay on it. A single box is not moved. O(n log n).
/// @param unit  0, or a power of two
std::vector<Vec2> packBoxes(const std::vector<UvBox>& boxes, double unit = 0);

/// The shift, a multiple of the same power of two, that moves the centre of a box closest to the origin.
Vec2 centringShift(const UvBox& box, double unit = 0);

}  // namespace hgp::api
