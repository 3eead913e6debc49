// Where a map got a cone's angle wrong by a multiple of 2π.  Role: [BCW17 §7.1].
#pragma once

#include "hgp/optimize/frames.h"

namespace hgp {

/// Whether every face around the cone has a frame: only then can its ring be embedded.
bool holdsRing(const TriMesh& mesh, const Frames& frames, VertexId cone);

/// New frames for the triangles around `cone`: its one-ring is embedded locally with the asked angle
/// 2πk/q. Interior angles at the cone minimise the summed squared deviation from those of `z` (made
/// positive) under Σ = 2πk/q; spoke lengths stay those of `z`.
/// The first triangle counterclockwise keeps its own frame; the others follow from it.
/// @param frames  changed in place for the faces around the cone
void embedConeRing(const TriMesh& mesh, const Geometry& geometry, const CutMesh& cut,
                   const SeamRotations& seams, const std::vector<Complex>& z, VertexId cone, int k,
                   Frames& frames);

}  // namespace hgp
