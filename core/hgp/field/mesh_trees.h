// One nested dissection for every factorization of a run.  Role: orders the Laplacian's nodes, the
// faces of the field and the unknowns of the harmonic rows from the same separators.
#pragma once

#include "hgp/field/filled_surface.h"
#include "hgp/linalg/ordering.h"

namespace hgp {

/// Vertices of the mesh, dissected along its edges; |V| entries.
linalg::SeparatorTree vertexTree(const TriMesh& mesh);

/// The nodes of the filled surface but node 0: entry n − 1 stands for node n.
/// @param tree  vertexTree(mesh)
linalg::SeparatorTree nodeTree(const TriMesh& mesh, const FilledSurface& surface,
                               const linalg::SeparatorTree& tree);

/// Faces, coupled across edges. A face goes where its first vertex is eliminated; where that leaves
/// two neighbours in separate branches, one of them moves up to the node that holds their edge. So
/// a separator of k edges costs k faces.
/// @param tree  vertexTree(mesh)
linalg::SeparatorTree faceTree(const TriMesh& mesh, const linalg::SeparatorTree& tree);

}  // namespace hgp
