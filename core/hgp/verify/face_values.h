// Distortion per triangle, and the triangles that overlap.  Role: for display; the verdict does not depend on it.
#pragma once

#include <vector>

#include "hgp/mesh/mesh_data.h"

namespace hgp {

/// Values for every stored triangle, in the order and with the orientation of the file.
struct FaceValues {
  std::vector<float> stretch;  ///< σ₁ / σ₂ ≥ 1 of the derivative; 1 keeps angles
  std::vector<float> logArea;  ///< log₂ of |uv area| / area, less that of all triangles together
  std::vector<int> notPositive;        ///< by exact sign, ascending: flipped or without area
  double surfaceArea = 0, uvArea = 0;  ///< of all, absolute values
};

/// Triangles without area on the surface have stretch 1 and logArea 0.
FaceValues measureFaces(const MeshData& mesh, const UvMap& map);

struct OverlapPairs {
  long long pairs = 0;         ///< of triangles that share area and no uv
  std::vector<int> triangles;  ///< in some pair, ascending
  bool isMore = false;         ///< counting stopped early: there are more pairs
};

/// Local injectivity allows distant parts to overlap. Neighbours, which share a uv, do not count, nor do parts
/// that touch within 1e-6 of the map's size. O(|F| log |F| + pairs); stops at `most` pairs.
OverlapPairs findOverlapPairs(const UvMap& map, long long most = 200'000);

}  // namespace hgp
