// Vertices with too few triangles for their prescribed angles.  Role: a proof, in integers, that no locally injective
// map has these angles, where strong cones are close to each other or to vertices of low valence.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "hgp/mesh/topology.h"
#include "hgp/mesh/tri_mesh.h"

namespace hgp {

/// Vertices W whose prescribed angles Θ_v = 2πk_v/q do not fit into the triangles T around them. In a locally injective
/// map the corners in W of a triangle have less than π together, or exactly π if all three are in W; Σ_W Θ_v is more
/// than the sum of these bounds over T. A boundary loop of n vertices with a given turning l is in W as a whole, with
/// Θ = πn − 2πl/q.
struct AngleShortage {
  std::vector<VertexId> cones;  ///< of W, strongest first
  std::vector<VertexId>
      regular;             ///< the other vertices of W, which lie between and around the cones
  std::vector<int> loops;  ///< of W, as numbered in Topology::loops
  int vertices = 0;        ///< |cones| + |regular|
  int triangles = 0;       ///< |T|
  double asked = 0.0;      ///< Σ_W Θ, radians
};

/// A boundary loop whose turning is given.
struct LoopAngle {
  int index = 0;  ///< in Topology::loops
  const BoundaryLoop* loop = nullptr;
  int turning = 0;  ///< l: Σ(π − θ_v) = 2πl/q
};
struct AngleQuestion {
  int q = 4;
  const PerVertex<int>& k;  ///< per vertex; q where there is no cone; ignored at boundary vertices
  std::vector<LoopAngle> loops;
};
/// Angles of the corners, radians, that about have the sums asked for; none where they are not to be had.
using NearAngles = std::function<std::optional<PerHalfedge<double>>(const AngleQuestion&)>;

/// Searches of findAngleShortage start only at cones whose mean corner angle is above this, in radians.
inline constexpr double kSteepCornerAngle = 1.4;

/// Angles are a flow from triangles to vertices. If a vertex gets less than Θ_v and no augmenting path is left, W is
/// the set that a search from it reaches (Hall's condition). Searches start at steep cones and end after kLargestSearch
/// vertices: a result is a proof, but an empty one does not prove that there is no shortage.
/// @param k  as in AngleQuestion
/// @param nearAngles  angles from which positive ones are soon found where they exist; they change time and no result
std::optional<AngleShortage> findAngleShortage(const TriMesh& mesh, int q, const PerVertex<int>& k,
                                               const NearAngles& nearAngles = {});
inline constexpr int kLargestSearch = 4000;

/// The same from every vertex and every given loop, with no limit but the number of visits in all: an empty result means
/// that positive angles exist, unless that limit (two million) is met. Milliseconds on a thousand triangles.
std::optional<AngleShortage> findAnyAngleShortage(const TriMesh& mesh,
                                                  const AngleQuestion& question,
                                                  const NearAngles& nearAngles = {});

}  // namespace hgp
