// Where the components of a map lie beside each other.  Role: far from the origin a number has fewer
// digits left for a triangle; small components therefore stay near it.
#pragma once

#include <vector>

#include "hgp/mesh/box.h"
#include "hgp/mesh/mesh_data.h"

namespace hgp::api {

using UvBox = Box<2>;

/// One shift per box, so that no two overlap and together they fill about a square with one corner at
/// the origin: by increasing size, in strips that are added to the right and on top by turns. A box of
/// size s lies within O(√(Σ areas of the boxes before it) + s) of the origin. Every shift is a
/// multiple of a power of two, at least 1/32 of the box, and of `unit` where that is larger: numbers
/// on a grid stay on it. One box alone stays where it is. O(n log n).
/// @param unit  0, or a power of two
std::vector<Vec2> packBoxes(const std::vector<UvBox>& boxes, double unit = 0);

/// The shift, a multiple of the same powers of two, that brings the middle of a box nearest the origin.
Vec2 centringShift(const UvBox& box, double unit = 0);

}  // namespace hgp::api
