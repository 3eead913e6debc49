// How harmonic a map is, measured on its uv.  Role: rows (7), (8), (14) of [BCW17] after the fact,
// whatever the map was made with.
#pragma once

#include "hgp/mesh/geometry.h"
#include "hgp/mesh/mesh_data.h"

namespace hgp {

/// A row that is off by more than this part of the mean uv edge at its vertex is violated.
inline constexpr double kHarmonicTolerance = 1e-6;

struct HarmonicFacts {
  int rows = 0;                ///< interior vertices that are no cones
  int violated = 0;            ///< above kHarmonicTolerance and what rounding can do there
  double largestResidual = 0;  ///< relative to the mean uv edge at the vertex
  VertexId worst;
};

/// At every interior vertex v that is no cone, with mean-value weights w of `geometry`,
///
///   | Σ_sectors e^{−i2πr_s/q} Σ_j w_ij (z_i − z_j) | / Σ w   over the mean length of the uv edges at v,
///
/// r_s read off the seams that are crossed counterclockwise from the first sector.
/// @param gridStep  that stored values were rounded to; 0: not rounded
HarmonicFacts measureHarmonicity(const TriMesh& mesh, const Geometry& geometry, const UvMap& map,
                                 int q, const std::vector<VertexId>& cones, double gridStep = 0.0);

}  // namespace hgp
