// An OBJ text with some of its faces divided or turned over.  Role: the lossless patch that --refine and
// --write-repairs need; every line but those of changed faces stays.
#pragma once

#include <string>

#include "hgp/io/polygon/obj_text.h"
#include "hgp/io/polygon/polygon_refine.h"

namespace hgp::io {

/// Changed faces take the place of their f line. New v, vt and vn lines follow the last of these lines
/// (or stand at the end of a file with relative indices): means of the two lines of their parents with
/// all their numbers, normals of length 1. Cones stored in the text are left out.
/// @param places  of `text`; its mesh and cornerUv are given apart
/// @param refined  made of `polygons`
std::string rewriteObjFaces(std::string_view text, const ObjText& places,
                            const PolygonMesh& polygons, const std::vector<int>& cornerUv,
                            RefinedPolygons refined);

}  // namespace hgp::io
