// Edges split at their midpoints.  Role: a mesh that is too coarse for what is asked, a little finer and
// of the same shape.
#pragma once

#include <array>
#include <vector>

#include "hgp/mesh/mesh_data.h"

namespace hgp {

/// An edge by its two vertices, the smaller first.
using VertexPair = std::array<int, 2>;

struct RefinedMesh {
  MeshData mesh;                    ///< vertices of before, then one midpoint per split edge
  std::vector<VertexPair> parents;  ///< of each new vertex: the ends of its edge
  std::vector<int> faceOrigin;      ///< face → face of before; children follow each other
  /// Of each corner the two corners (0 to 2) of the face of before that it is the mean of; equal where
  /// it is one of them. What is interpolated along an edge on both sides alike stays continuous.
  std::vector<std::array<std::array<int, 2>, 3>> cornerOrigin;
};

/// Divides every triangle with split edges: one split gives two triangles, two give three (the
/// remaining quadrilateral by its shorter diagonal), three give four. Conforming: an edge is split in
/// all of its triangles. Faces that name a vertex twice, and pairs that are no edge, are left alone.
RefinedMesh splitEdges(const MeshData& mesh, std::vector<VertexPair> edges);

}  // namespace hgp
