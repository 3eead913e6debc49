// An OBJ text with some edges of its faces split.  Role: the lossless patch that --refine needs; every line
// but the faces that are divided stays.
#pragma once

#include <string>

#include "hgp/io/polygon/obj_text.h"
#include "hgp/mesh/refine.h"

namespace hgp::io {

/// Divided faces become triangles in the place of their f line. New v, vt and vn lines follow the last
/// of these lines (or stand at the end of a file with relative indices): means of the two lines at the
/// ends of the edge with all their numbers, normals of length 1. Cones stored in the text are left out.
/// @param places  of `text`; its mesh and cornerUv are given apart
std::string refineObj(std::string_view text, const ObjText& places, const PolygonMesh& polygons,
                      const TriangleCorners& corners, const std::vector<int>& cornerUv,
                      const MeshData& triangles, const std::vector<VertexPair>& edges);

}  // namespace hgp::io
