// A numbering that keeps neighbours close together in memory.  Role: with triangles in scattered order
// every access to a neighbour is a cache miss (docs/decisions/024).
#pragma once

#include <vector>

#include "hgp/mesh/tri_mesh.h"

namespace hgp {

/// New number → old number.
struct Numbering {
  std::vector<int> vertices;
  std::vector<int> faces;
};

/// Whether the ids of adjacent faces, or of adjacent vertices, differ on average by more than a tenth of their number;
/// in random order they differ by a third.
bool isScattered(const TriMesh& mesh);

/// Breadth-first from the given surface's first face; isolated vertices last.
Numbering nearbyNumbering(const TriMesh& mesh);

/// The same surface with other ids. The order of corners within a face does not change, nor does the numbering of loops
/// and generators in topology.h (TriMesh::givenFace).
/// @pre every vertex and face occurs once
TriMesh renumbered(const TriMesh& mesh, const Numbering& numbering);

}  // namespace hgp
