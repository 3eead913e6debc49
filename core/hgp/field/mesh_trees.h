// One nested dissection for every large factorization of a run.  Role: orders the Laplacian's nodes
// and the unknowns of the harmonic rows from the same separators.
#pragma once

#include <optional>

#include "hgp/field/filled_surface.h"
#include "hgp/linalg/ordering/ordering.h"

namespace hgp {

/// Vertices of the mesh, dissected along its edges; |V| entries. Separators of width 2 serve matrices
/// that also couple the neighbours of a vertex with each other (LᴴL).
linalg::SeparatorTree vertexTree(const TriMesh& mesh, int separatorWidth = 1);

/// vertexTree(mesh, 2), computed when it is first needed. Keeps a reference to the mesh.
class WideTree {
 public:
  explicit WideTree(const TriMesh& mesh) : mesh_(&mesh) {}
  const linalg::SeparatorTree& get();

 private:
  const TriMesh* mesh_;
  std::optional<linalg::SeparatorTree> tree_;
};

/// The nodes of the filled surface but node 0: entry n − 1 stands for node n.
/// @param tree  vertexTree(mesh)
linalg::SeparatorTree nodeTree(const TriMesh& mesh, const FilledSurface& surface,
                               const linalg::SeparatorTree& tree);

}  // namespace hgp
