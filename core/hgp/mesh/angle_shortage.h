// Cones that a mesh has too few triangles for.  Role: a proof, in integers, that no locally injective map has the
// prescribed angles, where strong cones are close to each other or to vertices of few triangles.
#pragma once

#include <optional>
#include <vector>

#include "hgp/mesh/tri_mesh.h"

namespace hgp {

/// Vertices W whose angles Θ_v = 2πk_v/q do not fit into the triangles T around them: every triangle has less than π
/// for its corners in W, or exactly π if all three are, and Σ_W Θ_v asks for more.
struct AngleShortage {
  std::vector<VertexId>
      cones;           ///< of W, strongest first; the others are regular vertices between them
  int vertices = 0;    ///< |W|
  int triangles = 0;   ///< |T|
  double asked = 0.0;  ///< Σ_W Θ_v, radians
};

/// Mean corner angle above which a cone can be part of a shortage that is looked for, radians.
inline constexpr double kSteepCornerAngle = 1.4;

/// The angles are a flow from triangles to vertices; W is what is reached from a vertex that gets too little where no more can come
/// (Hall's condition). Looked for where a cone is steep, there first; searches end without a
/// result at kLargestSearch vertices: what is found is a proof, what is not found is none.
/// @param k  per vertex; q where there is no cone. What it says at boundary vertices does not count
std::optional<AngleShortage> findAngleShortage(const TriMesh& mesh, int q, const PerVertex<int>& k);
inline constexpr int kLargestSearch = 4000;

}  // namespace hgp
