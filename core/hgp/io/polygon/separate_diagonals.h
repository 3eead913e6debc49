// Diagonals that no other polygon has.  Role: keeps triangulating from making faces and edges that the file does not
// have: two quadrilaterals that share two edges (a doublet) would become two copies of one triangle.
#pragma once

#include <cstdint>

#include "hgp/io/polygons.h"

namespace hgp::io {

/// Chooses other triangles for polygons of which a diagonal joins two vertices that are joined by a side or by a
/// diagonal of another polygon, where there are such triangles; polygons with the same vertices in the same cyclic
/// order, in either direction, get the same triangles. Vertices at one position count as one, so that joining them
/// later makes nothing double either. Other polygons keep their triangles. Polygons of more than 64 corners are left.
/// @param tests  counted as by clipEars
void separateDiagonals(const PolygonMesh& polygons, TriangleCorners& corners, std::int64_t& tests);

}  // namespace hgp::io
