// Harmonicity of the cut mesh: the rows of L.  Role: §4 of [BCW17]; App. A for seam vertices.
#pragma once

#include "hgp/system/reduced_unknowns.h"
#include "hgp/system/weights.h"

namespace hgp {

struct HarmonicSystem {
  SparseRows rows;                  ///< |rows| × count, over the reduced unknowns
  std::vector<VertexId> rowVertex;  ///< ascending
};

/// One complex row per interior vertex of S that is not a cone.
///
///   Σ_s Σ_{v_j ∈ N*(v_i^s)} w_ij e^{−i2πr_s/q} (z_i^s − z_j) = 0,  Σ_j w_ij = 1      [BCW17 (14)]
///
/// (7) is the case without a seam, (8) that of degree 2. Here r_s = ReducedUnknowns::turn rotates the first sector into
/// sector s, so that differences are rotated back by −r_s; the paper's r_s is that correction (docs/errata.md, 6).
/// Assembled per triangle: each side of a seam edge contributes its half of w_ij, which gives the same row because the
/// two copies of the edge are equal up to the rotation. The same constant at all copies is in the kernel.
HarmonicSystem harmonicSystem(const TriMesh& mesh, const Geometry& geometry, const CutMesh& cut,
                              const ReducedUnknowns& unknowns, int q,
                              const std::vector<VertexId>& cones,
                              WeightKind kind = WeightKind::kMeanValue);

}  // namespace hgp
