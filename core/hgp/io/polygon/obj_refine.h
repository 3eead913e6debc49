// An OBJ text with some of its faces subdivided or reversed.  Role: the lossless patch for --refine and
// --write-repairs; all lines except those of changed faces stay.
#pragma once

#include <string>

#include "hgp/io/polygon/obj_text.h"
#include "hgp/io/polygon/polygon_refine.h"

namespace hgp::io {

/// Changed faces replace their f line. New v, vt and vn lines follow the last v, vt or vn line (in a file with
/// relative indices, the last line): each number is the mean of those of the two parents' lines, and normals
/// are normalised. Cones stored in the text are left out.
/// @param places  the result of scanObj for `text`; its mesh and cornerUv are passed separately
/// @param refined  the result of splitEdges or editFaces for `polygons`
std::string rewriteObjFaces(std::string_view text, const ObjText& places,
                            const PolygonMesh& polygons, const std::vector<int>& cornerUv,
                            RefinedPolygons refined);

}  // namespace hgp::io
