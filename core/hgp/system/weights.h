// Mean-value and cotangent weights.  Role: the positive convex combination weights w_ij of [BCW17 §7, Floater 2003].
#pragma once

#include <array>

#include "hgp/mesh/geometry.h"

namespace hgp {

/// The part of w_ij that one triangle contributes at its corner tail(h):
/// tan(α/2)/|v_j − v_i| towards head(h), and the same over the other edge towards the third vertex.
/// The two triangles of an edge add up to (tan(α/2) + tan(β/2))/|v_j − v_i|. Positive.
struct CornerWeights {
  double toHead;
  double toThird;
};
CornerWeights meanValueWeights(const Geometry& geometry, HalfedgeId h);

/// The same of half the cotangents of the two angles that face an edge, within bounds that keep them positive; each of the
/// edge's two triangles contributes half. Equal at both ends of an edge. None of the edges at tail(h) is on the boundary.
CornerWeights cotangentWeights(const TriMesh& mesh, const Geometry& geometry, HalfedgeId h);

/// Which weights rows of harmonic maps have. [BCW17] uses mean-value weights; its theorems hold for all positive ones.
enum class WeightKind : unsigned char { kMeanValue, kCotangent };
CornerWeights cornerWeights(WeightKind kind, const TriMesh& mesh, const Geometry& geometry,
                            HalfedgeId h);

}  // namespace hgp
