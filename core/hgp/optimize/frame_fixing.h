// New frames around a cone whose angle is wrong by a multiple of 2π in a map.  Role: frame fixing [BCW17 §7.1].
#pragma once

#include "hgp/optimize/frames.h"

namespace hgp {

/// Whether every face around the cone has a frame: only then can its ring be embedded.
bool holdsRing(const TriMesh& mesh, const Frames& frames, VertexId cone);

/// New frames for the triangles around `cone`: its one-ring is embedded locally with the prescribed angle
/// 2πk/q. Its interior angles at the cone are positive, have Σ = 2πk/q and minimise the sum of squared differences
/// from those of `z`; the lengths of the edges at the cone are those of `z`.
/// The first triangle counterclockwise keeps its own frame; the others follow from it.
/// @param frames  changed in place for the faces around the cone
void embedConeRing(const TriMesh& mesh, const Geometry& geometry, const CutMesh& cut,
                   const SeamRotations& seams, const std::vector<Complex>& z, VertexId cone, int k,
                   Frames& frames);

}  // namespace hgp
