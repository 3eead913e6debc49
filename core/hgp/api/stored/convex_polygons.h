// Polygons that are convex in the map.  Role: SolveOptions::convexPolygons; for readers that cut polygons along
// other diagonals than hgp.
#pragma once

#include "hgp/api/stored/stored_map.h"
#include "hgp/io/polygons.h"

namespace hgp::api {

/// Moves uv of components so that more polygons are convex. A vertex that is no cone and not on the boundary moves to
/// where the smallest area at it is largest: of its triangles and of the corners of its polygons; the function is
/// concave, since every area is linear in the moved point. Its copies along seams move alike. A component keeps its map
/// if the moved one is not certified.
void makePolygonsConvex(const Model& model, io::PolygonsView polygons,
                        std::vector<ComponentMap>& components);

}  // namespace hgp::api
