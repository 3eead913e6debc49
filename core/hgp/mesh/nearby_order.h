// A numbering that keeps neighbours close together in memory.  Role: files whose triangles lie in
// scattered order cost every stage a cache miss a neighbour (docs/decisions/024).
#pragma once

#include <vector>

#include "hgp/mesh/tri_mesh.h"

namespace hgp {

/// New number → old number.
struct Numbering {
  std::vector<int> vertices;
  std::vector<int> faces;
};

/// Whether the faces or vertices across an edge lie further apart than a tenth of their numbers on
/// average; in random order they lie a third apart.
bool isScattered(const TriMesh& mesh);

/// Breadth-first from the given surface's first face; isolated vertices last.
Numbering nearbyNumbering(const TriMesh& mesh);

/// The same surface under other numbers. Corners keep their places in their faces, and loops and
/// generators theirs in topology.h (TriMesh::givenFace).
/// @pre every vertex and face occurs once
TriMesh renumbered(const TriMesh& mesh, const Numbering& numbering);

}  // namespace hgp
