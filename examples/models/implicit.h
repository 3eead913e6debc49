// Surfaces as zero sets of functions.  Role: smooth models of any genus without a modelling
// program.
#pragma once

#include <functional>

#include "hgp/mesh/mesh_data.h"

namespace hgp::models {

/// Negative inside, positive outside, roughly a distance.
using Field = std::function<double(const Vec3&)>;

/// The zero set inside [−halfSize, halfSize]³ as an oriented closed manifold: the boundary of the voxels
/// whose centre is inside, smoothed and projected onto the zero set. Only the largest component.
MeshData surfaceOf(const Field& field, double halfSize, int cells);

/// Moves every vertex onto the zero set, by at most `reach`.
void project(MeshData& mesh, const Field& field, double reach);

/// Divides every triangle into four.
MeshData subdivide(const MeshData& mesh);

}  // namespace hgp::models
