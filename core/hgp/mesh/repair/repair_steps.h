// The three repairs of a mesh: degenerate, orient, split.  Role: the steps of fixDefects (mesh/defects.h).
#pragma once

#include "hgp/mesh/defects.h"

namespace hgp {

/// --fix degenerate. Leaves out faces that are not part of a surface: faces that name a vertex twice (their other two
/// sides run along one edge in opposite directions, so that leaving them out joins their neighbours), all but one of the
/// faces with the same corners (the one that agrees best with its neighbours' orientation stays), and components in
/// which no face has an area. Other faces without area stay: computeGeometry gives them lengths.
void leaveOut(FixResult& result);

/// --fix orient. Makes the orientation of every component consistent by flipping as few faces as possible; a closed
/// component of which more than a quarter would be flipped is oriented outwards (positive volume). One-sided components
/// are left as they are or, with isCutLater, made consistent along a spanning tree of their faces.
/// @return the number of one-sided components
int orientFaces(FixResult& result, bool isCutLater);

/// --fix split. Gives every fan of faces around a vertex its own copy of the vertex. Where an edge has more than two
/// faces, opposite ones are paired, flattest first; a face without a partner gets a boundary edge. Where
/// oneSided > 0 (from orientFaces), edges that two faces traverse in the same direction are cut.
void splitNonManifold(FixResult& result, int oneSided);

}  // namespace hgp
