// Distortion per triangle, and the triangles that overlap.  Role: for display; the verdict does not depend on it.
#pragma once

#include <vector>

#include "hgp/mesh/mesh_data.h"

namespace hgp {

/// Values for every stored triangle, in the order and with the orientation of the file.
struct FaceValues {
  std::vector<float> stretch;  ///< σ₁ / σ₂ ≥ 1 of the derivative; 1 keeps angles
  std::vector<float>
      logArea;  ///< log₂ of |uv area| / area at the best global scale of its component
  std::vector<int> notPositive;        ///< by exact sign, ascending: flipped or without area
  double surfaceArea = 0, uvArea = 0;  ///< of all, absolute values
};

/// The scale of areas is that of DistortionFacts: the mean of log₂ over a component, weighted by surface area, is 0.
/// Triangles without area on the surface have stretch 1 and logArea 0.
/// @param componentOf  of every triangle, −1: none; empty: all triangles are one component
FaceValues measureFaces(const MeshData& mesh, const UvMap& map,
                        const std::vector<int>& componentOf = {});

struct OverlapPairs {
  long long pairs = 0;         ///< of triangles that share area and no uv
  std::vector<int> triangles;  ///< in some pair, ascending
  bool isMore = false;         ///< counting stopped early: there are more pairs
};

/// Local injectivity allows distant parts to overlap. Neighbours, which share a uv, do not count, nor do parts
/// that touch within 1e-6 of the map's size. O(|F| log |F| + pairs); stops at `most` pairs.
OverlapPairs findOverlapPairs(const UvMap& map, long long most = 200'000);

}  // namespace hgp
