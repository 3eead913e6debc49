// Angle, valence, boundary and neighbours of every vertex of a triangle soup, manifold or not.  Role: clients show
// them where users place cones; the solver does not use them.
#pragma once

#include <cstdint>
#include <vector>

#include "hgp/mesh/mesh_data.h"

namespace hgp {

/// Triangles that name a vertex twice or one that does not exist count for nothing here.
struct VertexFacts {
  std::vector<double> angle;     ///< Θ_v: the sum of the triangle angles at v, radians
  std::vector<int> valence;      ///< triangles at v
  std::vector<char> isBoundary;  ///< an edge of v has one triangle
  /// Number of the set of triangles connected by vertices; sets are ordered by their smallest triangle. −1 for
  /// a vertex without triangles.
  std::vector<int> component;
  /// The neighbours of v, ascending: neighbours[neighbourStart[v]] … neighbours[neighbourStart[v + 1] − 1].
  std::vector<std::uint32_t> neighbourStart, neighbours;
  double area = 0;  ///< of all triangles, in the square of the mesh's own unit
};

VertexFacts vertexFacts(const MeshData& mesh);

}  // namespace hgp
