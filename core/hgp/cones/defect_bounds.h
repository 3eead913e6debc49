// How many units of 2π/q every node may have.  Role: keeps automatic cones admissible and their distortion bounded.
#pragma once

#include <vector>

#include "hgp/field/prescribed_field.h"

namespace hgp {

/// Bounds on the units q − k of a vertex and q + l of a loop: 1 ≤ k and 2k < q·valence at a vertex, and a turning index
/// in turningRange at a loop. In addition no vertex may be further from its own curvature than frames can turn, so that
/// a spike keeps its cone.
struct DefectBounds {
  std::vector<int> low, high;
};
/// @param largestTurn  radians per edge around a vertex, on average
DefectBounds defectBounds(const TriMesh& mesh, const FieldContext& context, int q,
                          double largestTurn);

}  // namespace hgp
