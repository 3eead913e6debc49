// A PLY file with some faces reversed or subdivided and some vertices copied.
// Role: the lossless patch for --write-repairs; every other byte of the body stays.
#pragma once

#include "hgp/io/polygon/ply_header.h"
#include "hgp/io/polygon/polygon_refine.h"

namespace hgp::io {

/// Copies of vertices follow the last vertex, with all properties of the original's row.
/// Fails with kUnsupported if faces are triangle strips or the type of vertex indices is too small.
/// @pre the two parents of every new vertex in `edited` are equal: it is a copy, not a mean
Result<std::string> editPlyFaces(std::string_view text, const PlyHeader& header,
                                 const RefinedPolygons& edited);

}  // namespace hgp::io
