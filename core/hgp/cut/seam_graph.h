// G_s: the edges along which S is cut to a disk.  Role: E_s, V_s of [BCW17 §3.3].
#pragma once

#include "hgp/field/filled_surface.h"

namespace hgp {

/// Edges of the seam graph. Cutting along them (and nothing else) leaves a disk whose boundary
/// passes every terminal: all cones and, with its loops shrunk to nodes, every boundary component.
///
/// Short by construction (tree–cotree): a Steiner tree over the terminals (Mehlhorn's 2-approximation), extended
/// to a spanning tree of shortest paths; a spanning tree of the dual graph without its edges; and the 2g edges that
/// are in neither. Leaves that are not terminals are trimmed. Paths are measured by edge length.
/// @pre one component
PerEdge<char> seamGraph(const TriMesh& mesh, const Geometry& geometry, const FilledSurface& surface,
                        const std::vector<VertexId>& cones);

}  // namespace hgp
