// Cone angles and turning angles of the metric that a map induces, as integers.
// Role: k_i of [BCW17 §5.2], l_j of Def. C.1, and Lemma 6.2 for what was measured.
#pragma once

#include <optional>
#include <vector>

#include "hgp/mesh/topology.h"
#include "hgp/verify/orientation.h"

namespace hgp {

/// Bounds for the distance of a measured angle to the nearest multiple of 2π/q, in radians.
struct AngleRule {
  double tolerance = 0;        ///< always accepted
  double largestRounding = 0;  ///< upper bound of what is accepted because of rounding
  PerVertex<double> rounding;  ///< how much storing can change the sum at a vertex; 0 without seams
  PerVertex<double> explained;  ///< how much the number type can change it (SeamRule::computing)
};
/// Upper bound of any tolerance, in units of 2π/q: the nearest integer must be beyond doubt.
inline constexpr double kLargestAngleAllowance = 0.25;

/// An angle compared with the nearest multiple of 2π/q, in radians.
struct AngleDistance {
  double excess = 0;    ///< the angle minus 2π·measured/q
  double distance = 0;  ///< |excess|
  double allowed = 0;   ///< largest accepted distance here
  bool isExplained =
      false;  ///< at most AngleRule::explained: due to the number type, not to the map

  bool isTooFar() const { return !(distance <= allowed); }
};

/// An interior vertex with angle sum Θ = 2πk/q, k as measured, up to `distance`; or one of a boundary loop whose corners
/// are prescribed.
struct MeasuredCone : AngleDistance {
  VertexId vertex;
  int asked = 0;     ///< prescribed k; q where no cone is prescribed
  int measured = 0;  ///< the nearest integer
};

/// A boundary loop with turning angle Σ(π − θ_v) = 2πl/q, up to `distance` [BCW17 Def. C.1].
struct MeasuredTurning : AngleDistance {
  LoopId loop;  ///< index into Topology::loops
  std::optional<int> asked;
  int measured = 0;
  bool isWrong = false;  ///< not as asked, or too far from the integer
};

struct AngleFacts {
  std::vector<MeasuredCone> cones;  ///< inner ones: asked ones and all with measured ≠ q, ascending
  std::vector<MeasuredCone> wrong;  ///< not as asked, or too far from the integer, ascending
  double worstDistance = 0;         ///< over all interior vertices, radians
  VertexId worstVertex;
  double allowedThere = 0;                ///< at worstVertex, radians
  std::vector<MeasuredTurning> turnings;  ///< every loop
  std::vector<VertexId> overlapping;      ///< boundary vertices with θ_v > 2π: allowed, reported
  double smallestAngle = 0;               ///< of all triangles' corners, radians
  long long turnSum = 0;  ///< Σ(q − k) + Σl of what was measured [BCW17 Lemma 6.2]
};

/// An angle in [0, π] as a vector (r cos, r sin), r in [1, √2]: sums of such angles need one arc tangent.
using AngleVector = Vec2;

/// A sum of angles in [0, π], with an absolute error of a few 1e-16 per angle.
class AngleSum {
 public:
  void add(const AngleVector& angle);
  double radians() const;

 private:
  Vec2 direction_{1.0, 0.0};  ///< of the sum up to full turns, which are counted
  int turns_ = 0;
};

/// Interior angle at the tail of every halfedge, in [0, π], of the metric induced by uv (a reversed
/// triangle has the angles of its mirror image). Absolute error a few 1e-16 at any scale.
PerHalfedge<AngleVector> computeUvAngles(const TriMesh& mesh, const CornerUv& uv);

/// The prescribed angles.
struct AskedAngles {
  int q = 4;
  PerVertex<int>
      k;  ///< per vertex; q where regular; 0 at boundary vertices, where none is prescribed
  PerVertex<char> isCone;                   ///< 1 where a cone is prescribed
  bool isAnyConeAllowed = false;            ///< if isCone = 0, every measured k ≥ 1 is accepted
  std::vector<std::optional<int>> turning;  ///< per loop
};

AngleFacts measureAngles(const TriMesh& mesh, const Topology& topology, const AskedAngles& asked,
                         const PerHalfedge<AngleVector>& angle, const AngleRule& rule);

}  // namespace hgp
