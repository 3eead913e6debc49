// Components, Euler characteristic, genus, boundary loops and handle generators of S.
// Role: g and m of [BCW17 §3.3] and a homology basis for the holonomy.
#pragma once

#include <vector>

#include "hgp/mesh/tri_mesh.h"

namespace hgp {

/// One boundary component B_j: boundary halfedges in order, head of each = tail of the next, the
/// surface on their left. Starts at the first halfedge as given (TriMesh::givenHalfedge).
struct BoundaryLoop {
  std::vector<HalfedgeId> halfedges;
};

struct Topology {
  int componentCount = 0;
  PerFace<int> component;           ///< per face
  int eulerCharacteristic = 0;      ///< V − E + F over vertices that have faces
  int genus = 0;                    ///< sum over components
  std::vector<BoundaryLoop> loops;  ///< ascending by first halfedge as given
  int isolatedVertexCount = 0;
};

Topology computeTopology(const TriMesh& mesh);

/// One closed walk in the dual graph: `crossed[n]` is the halfedge of the face being left, its twin
/// lies in the next face; the last leads back to the first face.
struct DualLoop {
  std::vector<HalfedgeId> crossed;
};

/// 2g dual loops generating the handles' homology of a connected S with its boundary loops filled
/// in (tree–cotree). Deterministic: they depend on connectivity and the given order of faces alone, so
/// that generator i means the same in every run and file. Precondition: one component.
std::vector<DualLoop> handleGenerators(const TriMesh& mesh);

/// A connected component of a mesh as a separate mesh.
struct Component {
  MeshData mesh;
  std::vector<int> vertexOrigin;  ///< ascending
  std::vector<int> faceOrigin;    ///< ascending
};
std::vector<Component> splitComponents(const MeshData& data, const TriMesh& mesh,
                                       const Topology& topology);

}  // namespace hgp
