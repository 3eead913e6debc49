// Edges split at their midpoints.  Role: refines a mesh that is too coarse for a prescription, without
// changing its shape.
#pragma once

#include <array>
#include <vector>

#include "hgp/mesh/mesh_data.h"

namespace hgp {

/// An edge by its two vertices, the smaller first.
using VertexPair = std::array<int, 2>;

struct RefinedMesh {
  MeshData mesh;                    ///< the old vertices, then one midpoint per split edge
  std::vector<VertexPair> parents;  ///< of each new vertex: the ends of its edge
  std::vector<int> faceOrigin;      ///< face → old face; the children of a face are consecutive
  /// For each corner, the two corners (0 to 2) of the old face of which it is the mean; equal for an old
  /// corner. Attributes interpolated accordingly stay continuous across edges.
  std::vector<std::array<std::array<int, 2>, 3>> cornerOrigin;
};

/// Divides every triangle with split edges: one split gives two triangles, two give three (the
/// remaining quadrilateral by its shorter diagonal), three give four. Conforming: an edge is split in
/// all of its triangles. Faces with a repeated vertex and pairs that are not an edge are ignored.
RefinedMesh splitEdges(const MeshData& mesh, std::vector<VertexPair> edges);

}  // namespace hgp
