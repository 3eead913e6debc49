// Vertices with too few triangles for their prescribed angles.  Role: a proof, in integers, that no locally injective
// map has these angles, where strong cones are close to each other or to vertices of low valence.
#pragma once

#include <optional>
#include <vector>

#include "hgp/mesh/tri_mesh.h"

namespace hgp {

/// Vertices W whose prescribed angles Θ_v = 2πk_v/q do not fit into the triangles T around them. In a locally injective
/// map the corners in W of a triangle have less than π together, or exactly π if all three are in W; Σ_W Θ_v is more
/// than the sum of these bounds over T.
struct AngleShortage {
  std::vector<VertexId>
      cones;           ///< of W, strongest first; the others are regular vertices between them
  int vertices = 0;    ///< |W|
  int triangles = 0;   ///< |T|
  double asked = 0.0;  ///< Σ_W Θ_v, radians
};

/// Searches start only at cones whose mean corner angle is above this, in radians.
inline constexpr double kSteepCornerAngle = 1.4;

/// Angles are a flow from triangles to vertices. If a vertex gets less than Θ_v and no augmenting path is left, W is
/// the set that a search from it reaches (Hall's condition). Searches start at steep cones and end after kLargestSearch
/// vertices: a result is a proof, but an empty one does not prove that there is no shortage.
/// @param k  per vertex; q where there is no cone; ignored at boundary vertices
std::optional<AngleShortage> findAngleShortage(const TriMesh& mesh, int q, const PerVertex<int>& k);
inline constexpr int kLargestSearch = 4000;

}  // namespace hgp
