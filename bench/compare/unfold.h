// Lays out a flat metric with cones in the plane.  Role: converts lengths of a conformal method to a map.
#pragma once

#include "hgp/cut/cut_mesh.h"

namespace hgp::bench {

/// One position per copy: triangle after triangle, breadth first, never across a seam.
/// @param length  of the halfedge's edge; triangle inequalities hold
/// @pre isDisk(mesh, cut)
std::vector<Complex> unfold(const TriMesh& mesh, const CutMesh& cut,
                            const PerHalfedge<double>& length);

}  // namespace hgp::bench
