// New frames around a cone whose angle is wrong by a multiple of 2π in a map.  Role: frame fixing [BCW17 §7.1].
#pragma once

#include "hgp/optimize/frames.h"

namespace hgp {

/// Whether every face around the cone has a frame: only then can its ring be embedded.
bool holdsRing(const TriMesh& mesh, const Frames& frames, VertexId cone);

/// New frames for the triangles around `cone`: its one-ring is embedded locally with the prescribed angle
/// 2πk/q. Its interior angles at the cone are positive, have Σ = 2πk/q and minimise the sum of squared differences
/// from those of `z`; the lengths of the edges at the cone are those of `z`.
/// The ring is laid down along its first edge in `z`; the frame of each triangle is what turns its similarity part
/// there, f_z, to the real axis. All frames of the ring are replaced, that of the first triangle, too.
/// Angles are kept between 1/20 and 20 times their mean and below 0.98π.
/// @param frames  changed in place for the faces around the cone
void embedConeRing(const TriMesh& mesh, const Geometry& geometry, const CutMesh& cut,
                   const SeamRotations& seams, const std::vector<Complex>& z, VertexId cone, int k,
                   Frames& frames);

}  // namespace hgp
