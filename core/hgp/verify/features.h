// Feature edges in a map: are they straight?  Role: lines u = const or v = const in the stored numbers, without any
// tolerance; reads the map and the list of edges alone.
#pragma once

#include <vector>

#include "hgp/verify/angles.h"

namespace hgp {

/// A feature edge is straight where, on each of its sides, both ends have the same u or the same v, bit for bit, and not
/// both. A chain is a run of feature edges between its ends: vertices where the number of feature edges is not 2, and
/// corners, where the lines of the map turn. A closed run without ends is one chain.
struct FeatureFacts {
  int edges = 0;  ///< in the list
  int straightEdges = 0;
  int chains = 0;
  int straightChains = 0;           ///< with straight edges only
  int corners = 0;                  ///< vertices between two feature edges at which a line turns
  std::vector<EdgeId> notStraight;  ///< ascending
};

/// @param features  edges of the mesh
/// @param uv        as stored
/// @param angle     computeUvAngles of it
FeatureFacts measureFeatures(const TriMesh& mesh, const std::vector<EdgeId>& features,
                             const CornerUv& uv, const PerHalfedge<AngleVector>& angle);

}  // namespace hgp
