// The corners of a rectangle.  Role: chooses the four vertices of a rim that a map sends to right angles.
#pragma once

#include <array>
#include <optional>

#include "hgp/mesh/geometry.h"
#include "hgp/mesh/topology.h"

namespace hgp {

/// Four vertices of a loop in its order: those at which it turns most, and more evenly spaced where it turns alike. They
/// maximise Σ T(v_i) − kUneven Σ (4 g_i / L − 1)², with L the length of the loop, g_i the lengths between consecutive
/// corners and T(v) = Σ (1 − 48 d/L)₊ (π − θ) over the loop's vertices, θ their angles, d their distances from v along it.
/// Nothing for a loop of fewer than four edges.
std::optional<std::array<VertexId, 4>> rectangleCorners(const TriMesh& mesh,
                                                        const Geometry& geometry,
                                                        const BoundaryLoop& loop);

}  // namespace hgp
