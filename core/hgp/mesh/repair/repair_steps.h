// The three repairs, one at a time.  Role: what fixDefects is made of.
#pragma once

#include "hgp/mesh/defects.h"

namespace hgp {

/// Leaves out what is no part of a surface: faces that name a vertex twice (their other sides run along
/// one edge in opposite directions: leaving them out glues their neighbours), all but one of faces with
/// the same corners (the one that fits its neighbours' direction best stays), and components in which
/// no face has an area. Other faces without area stay: computeGeometry gives them lengths.
void leaveOut(FixResult& result);

/// Makes every component consistent by flipping as few faces as possible; a closed one of which more
/// than a quarter would be flipped, outwards (positive volume). One-sided surfaces are left as they are, or
/// with isCutLater made consistent along a spanning tree of their faces. Returns their number.
int orientFaces(FixResult& result, bool isCutLater);

/// Gives every fan of faces around a vertex its own copy of the vertex. Of more than two faces on an
/// edge, opposite ones are paired, flattest first; what finds no partner becomes boundary. Where
/// oneSided > 0 (their number), edges that two faces run along in the same direction are cut.
void splitNonManifold(FixResult& result, int oneSided);

}  // namespace hgp
