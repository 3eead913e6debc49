// Sets of triangles grown by rings.  Role: the neighbourhoods in which a program or a repair is solved again.
#pragma once

#include <vector>

#include "hgp/mesh/tri_mesh.h"

namespace hgp {

/// `faces` and all faces within this many rings of vertices, ascending: each ring adds those that share a vertex.
std::vector<FaceId> growFaces(const TriMesh& mesh, const std::vector<FaceId>& faces, int rings);

/// The same in sets that have no vertex in common and can therefore be solved independently.
std::vector<std::vector<FaceId>> patchesAround(const TriMesh& mesh,
                                               const std::vector<FaceId>& faces, int rings);

}  // namespace hgp
