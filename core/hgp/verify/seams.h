// Seams: where the two sides of an edge have different uv.  Role: (12) of [BCW17] and the rotations
// along handles, read off the map.
#pragma once

#include <optional>
#include <vector>

#include "hgp/mesh/topology.h"
#include "hgp/verify/orientation.h"

namespace hgp {

/// The rotation of a seam edge is certain only when its residual is below this fraction of the distance to the next
/// multiple of 2π/q; an edge so short that rounding hides its direction has no rotation.
inline constexpr double kRotationShare = 0.25;

/// Bounds for residuals. Lengths are in uv units.
struct SeamRule {
  double tolerance = 0;  ///< accepted residual relative to the edge's own length
  double rounding = 0;   ///< what storing can add to a residual; 0 where nothing was rounded
  double largestRounding =
      0;  ///< upper bound of the part of `rounding` that is accepted, relative to that length
  double computing = 0;  ///< residuals up to this are due to the number type
};

/// An interior edge whose uv on its two sides differ. With f the face of mesh.halfedge(edge), g the
/// face across, and d the uv vector of the edge along that halfedge:  d_g = e^{i2πr/q} d_f + rest.
struct MeasuredSeam {
  EdgeId edge;
  int r = 0;                  ///< ∈ {0, …, q − 1}: the rotation that fits best
  double residual = 0;        ///< |rest| in uv units
  double lengthResidual = 0;  ///< | |d_g| − |d_f| | in uv units
  double length = 0;          ///< min(|d_f|, |d_g|) in uv units
  double allowed = 0;         ///< largest accepted residual of this edge, in uv units
  bool hasRotation = false;   ///< r is beyond doubt
  bool isExplained = false;   ///< the number type explains the residual: SeamRule::computing

  bool isBroken() const { return !hasRotation || !(residual <= allowed); }
  /// The residual as a part of the edge's own length; infinite for an edge without length.
  double relativeResidual() const;
};

struct MeasuredHandle {
  int index = 0;                ///< of handleGenerators
  std::optional<int> asked;     ///< in {0, …, q − 1}
  std::optional<int> measured;  ///< Σ r along the loop mod q; empty when a seam has no rotation
};

struct SeamFacts {
  std::vector<MeasuredSeam> seams;    ///< every seam edge, ascending
  std::vector<MeasuredSeam> broken;   ///< no rotation by a multiple of 2π/q within what is allowed
  int chartCount = 0;                 ///< connected components of the surface cut along the seams
  std::optional<MeasuredSeam> worst;  ///< the largest residual / allowed
  double largestRelativeResidual = 0;  ///< over all seam edges, relative to their own lengths
  double worstLengthResidual = 0;      ///< in uv units
  double maxUv = 0;                    ///< max(|u|, |v|)
  double meanEdge = 0;                 ///< mean uv edge length over all triangle sides
  std::vector<MeasuredHandle> handles;
};

/// Is a's residual larger than b's, each in parts of what is allowed? Broken ones come first.
bool isWorse(const MeasuredSeam& a, const MeasuredSeam& b);

/// max(|u|, |v|) over all corners.
double largestCoordinate(const CornerUv& uv);

/// An edge is accepted when its residual is at most `tolerance` of its own length, plus, where values
/// were rounded to be stored, `rounding`, as far as that is at most `largestRounding` of the length.
/// @return  everything but `handles`
SeamFacts measureSeams(const TriMesh& mesh, int q, const CornerUv& uv, const SeamRule& rule);

/// How far the seams at each vertex may turn its angle sum, in radians.
struct SeamTurns {
  PerVertex<double> rounding;   ///< by SeamRule::rounding
  PerVertex<double> explained;  ///< by the residuals that are explained
};
SeamTurns seamTurns(const TriMesh& mesh, const SeamFacts& seams, const SeamRule& rule);

/// Σ r along each loop; a loop that crosses a seam without rotation has none.
std::vector<MeasuredHandle> measureHandles(const TriMesh& mesh, int q,
                                           const std::vector<DualLoop>& loops,
                                           const SeamFacts& seams);

}  // namespace hgp
