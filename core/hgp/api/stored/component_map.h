// The parts of a map on the surface's triangles that belong to its components.  Role: between the map of a file and the
// maps that are certified.
#pragma once

#include "hgp/api/model/model.h"

namespace hgp::api {

/// The spacing of float32 numbers at the largest |u|, |v| or |1 − v| of a component: glTF
/// stores u and 1 − v, and its writer rounds each component to one grid.
double gridStep(const UvMap& map);

/// The component of every triangle of the surface; −1 if it is left out.
std::vector<int> componentOfTriangle(const Model& model);

/// The part of a map on the surface's triangles that belongs to one component, with its own uv indices.
UvMap mapOfComponent(const ModelComponent& component, const UvMap& surfaceMap);

/// Cells per side for measureOverlap: 512, or fewer for few triangles.
int overlapCells(const UvMap& map);

}  // namespace hgp::api
