// Edges that leave lines along features no room.  Role: the triangles of plain CAD lie between features; where these edges
// are split, each patch has vertices of its own.
#pragma once

#include <vector>

#include "hgp/mesh/tri_mesh.h"

namespace hgp {

/// One edge of every triangle with three feature edges, which no map can send to lines along two axes: one that two such
/// triangles have in common, if there is one, and of equally good ones the longest. Ascending.
/// @param features  contain all boundary edges
std::vector<EdgeId> edgesOfCrowded(const TriMesh& mesh, const std::vector<EdgeId>& features);

/// Edges that are no features and join two vertices on features: where both ends are on one line, such an edge has no
/// length in the map. Ascending.
std::vector<EdgeId> chords(const TriMesh& mesh, const std::vector<EdgeId>& features);

/// The edges of all triangles that have a vertex on features, features included. Ascending.
std::vector<EdgeId> edgesAround(const TriMesh& mesh, const std::vector<EdgeId>& features);

}  // namespace hgp
