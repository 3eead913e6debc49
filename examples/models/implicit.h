// Surfaces as the zero set of a function.  Role: organic models of any genus without a modelling
// program.
#pragma once

#include <functional>

#include "hgp/mesh/mesh_data.h"

namespace hgp::models {

/// Negative inside, positive outside, roughly a distance.
using Field = std::function<double(const Vec3&)>;

/// The zero set inside [−halfSize, halfSize]³ as an oriented closed manifold: boundary of the voxels
/// whose centre is inside, smoothed and drawn onto the zero set. Of several pieces the largest.
MeshData surfaceOf(const Field& field, double halfSize, int cells);

/// Moves every vertex onto the zero set, `reach` at most.
void project(MeshData& mesh, const Field& field, double reach);

/// Every triangle into four.
MeshData subdivide(const MeshData& mesh);

}  // namespace hgp::models
