// Seams: where the two sides of an edge have different uv.  Role: (12) of [BCW17] and the rotations
// along handles, read off the map.
#pragma once

#include <optional>
#include <vector>

#include "hgp/mesh/topology.h"
#include "hgp/verify/orientation.h"

namespace hgp {

/// A seam's rotation is certain only when its residual is below this part of the distance to the next
/// multiple of 2π/q; an edge so short that rounding hides its direction has no rotation.
inline constexpr double kRotationShare = 0.25;

/// An interior edge whose uv on its two sides differ. With f the face of mesh.halfedge(edge), g the
/// face across, and d the uv vector of the edge along that halfedge:  d_g = e^{i2πr/q} d_f + rest.
struct MeasuredSeam {
  EdgeId edge;
  int r = 0;                  ///< ∈ {0, …, q − 1}: the rotation that fits best
  double residual = 0;        ///< |rest| in uv units
  double lengthResidual = 0;  ///< | |d_g| − |d_f| | in uv units
  double length = 0;          ///< min(|d_f|, |d_g|) in uv units
};

struct MeasuredHandle {
  int index = 0;                ///< of handleGenerators
  std::optional<int> asked;     ///< in {0, …, q − 1}
  std::optional<int> measured;  ///< Σ r along the loop mod q; empty when it crosses a broken seam
};

struct SeamFacts {
  std::vector<MeasuredSeam> seams;   ///< every seam edge, ascending
  std::vector<MeasuredSeam> broken;  ///< no rotation by a multiple of 2π/q within tolerance
  int chartCount = 0;                ///< pieces the seams cut the surface into
  double worstResidual = 0;          ///< in uv units
  double worstLengthResidual = 0;    ///< in uv units
  EdgeId worstEdge;                  ///< of worstResidual
  double tolerance = 0;              ///< in uv units: what was accepted
  double maxUv = 0;                  ///< max(|u|, |v|)
  double meanEdge = 0;               ///< mean uv edge length over all triangle sides
  std::vector<MeasuredHandle> handles;
};

/// @param relativeTolerance  accepted residual relative to max(|u|, |v|)
/// @return  everything but `handles`
SeamFacts measureSeams(const TriMesh& mesh, int q, const CornerUv& uv, double relativeTolerance);

/// By how much the residuals of the seams that were accepted can change the angle sum at each vertex,
/// in units of 2π/q.
PerVertex<double> seamSlack(const TriMesh& mesh, int q, const SeamFacts& seams);

/// Σ r along each loop; a loop that crosses a broken seam has none.
std::vector<MeasuredHandle> measureHandles(const TriMesh& mesh, int q,
                                           const std::vector<DualLoop>& loops,
                                           const SeamFacts& seams);

}  // namespace hgp
