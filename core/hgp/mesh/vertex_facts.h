// What is known of every vertex of a triangle soup, manifold or not.  Role: what clients show, and let a person
// place cones by; nothing is solved with it.
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
  /// Of the sets of triangles that are connected by vertices, numbered by their smallest triangle; −1 for
  /// a vertex without triangles.
  std::vector<int> component;
  /// The neighbours of v, ascending: neighbours[neighbourStart[v]] … neighbours[neighbourStart[v + 1] − 1].
  std::vector<std::uint32_t> neighbourStart, neighbours;
  double area = 0;  ///< of all triangles, in the square of the mesh's own unit
};

VertexFacts vertexFacts(const MeshData& mesh);

}  // namespace hgp
