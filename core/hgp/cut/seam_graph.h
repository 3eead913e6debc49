// G_s: the edges along which S is cut to a disk.  Role: E_s, V_s of [BCW17 §3.3].
#pragma once

#include "hgp/field/filled_surface.h"

namespace hgp {

/// Edges of the seam graph. Cutting along them (and nothing else) leaves a disk whose boundary
/// passes every terminal: all cones and, with its loops shrunk to nodes, every boundary component.
///
/// Short by construction: a Steiner tree over the terminals (Mehlhorn's 2-approximation), extended
/// to a spanning tree of shortest paths, a dual tree of the rest, and the 2g edges that neither
/// takes; leaves that are no terminals are trimmed. Path lengths are edge lengths.
/// @pre one component
PerEdge<char> seamGraph(const TriMesh& mesh, const Geometry& geometry, const FilledSurface& surface,
                        const std::vector<VertexId>& cones);

}  // namespace hgp
