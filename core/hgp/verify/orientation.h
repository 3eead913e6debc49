// The exact orientation of every triangle of the map.  Role: "orientation preserving" of
// [BCW17 Thm 6.1], decided without rounding.
#pragma once

#include <vector>

#include "hgp/mesh/mesh_data.h"
#include "hgp/mesh/tri_mesh.h"

namespace hgp {

/// uv of the corner at the tail of every halfedge: the map as each triangle sees it.
using CornerUv = PerHalfedge<Vec2>;

/// Sign (−1, 0, +1) of the signed area of (a, b, c): exact for all finite doubles, also where the
/// area itself underflows or overflows.
int orientationSign(const Vec2& a, const Vec2& b, const Vec2& c);

/// The same by wide integers alone, without the floating-point filter (for tests and hard cases).
int exactOrientationSign(const Vec2& a, const Vec2& b, const Vec2& c);

/// Twice the signed area: computed in exact integers and rounded at the end, so that nothing cancels; 0 or ±infinity
/// where it leaves the range of doubles.
double exactTwiceArea(const Vec2& a, const Vec2& b, const Vec2& c);

struct OrientationFacts {
  int positive = 0, zero = 0, negative = 0;  ///< add up to |F|
  std::vector<FaceId> notPositive;           ///< every one of them, ascending
  int constrained = 0;                       ///< |F_cb|: triangles with a cone or a boundary vertex
  int constrainedPositive = 0;               ///< of those
};

/// @param isCone  1 at the cones asked for
OrientationFacts measureOrientation(const TriMesh& mesh, const PerVertex<char>& isCone,
                                    const CornerUv& uv);

}  // namespace hgp
