// How harmonic a map is, measured on its uv.  Role: residuals of rows (7), (8), (14) of [BCW17] for any
// map, however it was computed.
#pragma once

#include "hgp/mesh/geometry.h"
#include "hgp/mesh/mesh_data.h"
#include "hgp/system/weights.h"

namespace hgp {

/// A row is violated when its residual exceeds this fraction of the mean uv edge length at its vertex.
inline constexpr double kHarmonicTolerance = 1e-6;

struct HarmonicFacts {
  WeightKind weights = WeightKind::kMeanValue;
  int rows = 0;                ///< interior vertices that are not cones
  int violated = 0;            ///< above kHarmonicTolerance plus what rounding can cause there
  double largestResidual = 0;  ///< relative to the mean uv edge at the vertex
  VertexId worst;
};

/// At every interior vertex v that is not a cone, with mean-value weights w of `geometry` or, where rows with these are
/// violated and none of those with cotangents is, with cotangent weights,
///
///   | Σ_sectors e^{−i2πr_s/q} Σ_j w_ij (z_i − z_j) | / Σ w   over the mean length of the uv edges at v,
///
/// r_s read off the seams that are crossed counterclockwise from the first sector.
/// @param gridStep  the step, in uv units, to which stored values were rounded; 0: not rounded
HarmonicFacts measureHarmonicity(const TriMesh& mesh, const Geometry& geometry, const UvMap& map,
                                 int q, const std::vector<VertexId>& cones, double gridStep = 0.0);

}  // namespace hgp
