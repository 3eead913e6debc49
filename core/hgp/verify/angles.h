// Cone angles and turning angles of the metric that a map induces, as integers.
// Role: k_i of [BCW17 §5.2], l_j of Def. C.1, and Lemma 6.2 for what was measured.
#pragma once

#include <optional>
#include <vector>

#include "hgp/mesh/topology.h"
#include "hgp/verify/orientation.h"

namespace hgp {

/// Accepted distance of a measured angle to an integer, in units of 2π/q. Angle sums are computed to
/// about 1e-14, so this leaves room and would still see a seam off by a millionth of its length.
inline constexpr double kAngleTolerance = 1e-6;
/// With the slack of accepted seam residuals added, the nearest integer stays beyond doubt.
inline constexpr double kLargestAngleAllowance = 0.25;

/// An interior vertex with its angle sum Θ = 2π(measured + offset)/q, |offset| ≤ ½.
struct MeasuredCone {
  VertexId vertex;
  int asked = 0;        ///< k; q where no cone was asked for
  int measured = 0;     ///< the nearest integer
  double distance = 0;  ///< |offset|: distance to that integer
};

/// A boundary loop with turning angle Σ(π − θ_v) = 2π(measured + offset)/q [BCW17 Def. C.1].
struct MeasuredTurning {
  LoopId loop;  ///< index into Topology::loops
  std::optional<int> asked;
  int measured = 0;
  double distance = 0;
  bool isWrong = false;  ///< not as asked, or too far from the integer
};

struct AngleFacts {
  std::vector<MeasuredCone> cones;  ///< asked ones and all with measured ≠ q, ascending
  std::vector<MeasuredCone> wrong;  ///< not as asked, or too far from the integer, ascending
  double worstDistance = 0;         ///< over all interior vertices
  VertexId worstVertex;
  std::vector<MeasuredTurning> turnings;  ///< every loop
  std::vector<VertexId> overlapping;      ///< boundary vertices with θ_v > 2π: allowed, reported
  double smallestAngle = 0;               ///< of all triangles' corners, radians
  long long turnSum = 0;  ///< Σ(q − k) + Σl of what was measured [BCW17 Lemma 6.2]
};

/// Interior angle at the tail of every halfedge, in [0, π], of the metric induced by uv (a reversed
/// triangle has the angles of its mirror image). Absolute error a few 1e-16 at any scale.
PerHalfedge<double> computeUvAngles(const TriMesh& mesh, const CornerUv& uv);

/// What the angles are compared with.
struct AskedAngles {
  int q = 4;
  PerVertex<int> k;                         ///< per vertex; q where regular
  PerVertex<char> isCone;                   ///< 1 where a cone was asked for
  bool isAnyConeAllowed = false;            ///< where isCone = 0, every measured k ≥ 1 will do
  std::vector<std::optional<int>> turning;  ///< per loop
};

/// @param slack  what the accepted seam residuals at each vertex can turn it by, in units of 2π/q;
///               comes on top of kAngleTolerance
AngleFacts measureAngles(const TriMesh& mesh, const Topology& topology, const AskedAngles& asked,
                         const PerHalfedge<double>& angle, const PerVertex<double>& slack);

}  // namespace hgp
