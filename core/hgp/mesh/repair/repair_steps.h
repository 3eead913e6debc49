// The three repairs, one at a time.  Role: what fixDefects is made of.
#pragma once

#include "hgp/mesh/defects.h"

namespace hgp {

/// Drops faces that name a vertex twice, extra copies of faces, and faces without area. A needle (two
/// corners in one place) is closed by merging them; in a cap (a corner on the opposite side) that
/// side is flipped into the neighbour, which splits the neighbour where the corner lies. Neither
/// moves a point or opens a gap. What both would damage is nudged apart by kNudge of its length.
/// Vertices keep their numbers; merged ones stay behind without faces.
void removeDegenerate(FixResult& result);
inline constexpr double kNudge = 1e-4;

/// Makes every component consistent by flipping faces: outwards (positive volume) where it is
/// closed, with the larger part where it has a boundary. One-sided surfaces are left as they are, or
/// with isCutLater made consistent along a spanning tree of their faces. Returns their number.
int orientFaces(FixResult& result, bool isCutLater);

/// Gives every fan of faces around a vertex its own copy of the vertex. Of more than two faces on an
/// edge, opposite ones are paired, flattest first; what finds no partner becomes boundary. Where
/// oneSided > 0 (their number), edges that two faces run along in the same direction are cut.
void splitNonManifold(FixResult& result, int oneSided);

}  // namespace hgp
