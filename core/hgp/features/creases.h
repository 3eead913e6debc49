// Creases found by their dihedral angles.  Role: features that nobody has listed.
#pragma once

#include <vector>

#include "hgp/mesh/tri_mesh.h"

namespace hgp {

/// Above this dihedral angle, in degrees, an edge is a crease by default: on remeshed parts the edges above it are those that
/// their authors list.
inline constexpr double kCreaseDegrees = 30.0;
/// Creases continue over edges with this share of the angle.
inline constexpr double kWeakShare = 0.6;
inline constexpr int kLongestBridge = 3;
/// Pieces that end nowhere and have fewer edges than this are noise.
inline constexpr int kShortestSpur = 3;

/// Inner edges whose triangles' normals differ by more than `degrees`. A crease that ends is continued along the straightest
/// edges above kWeakShare · degrees, at most kLongestBridge, to another one; where it meets none, it stays as it was. Then pieces with a free
/// end and fewer than kShortestSpur edges are removed.
/// Ascending.
std::vector<EdgeId> findCreases(const TriMesh& mesh, double degrees = kCreaseDegrees);

/// Runs of edges between vertices at which not just two of them meet; a closed run without such a vertex is one.
int countRuns(const TriMesh& mesh, const std::vector<EdgeId>& edges);

}  // namespace hgp
