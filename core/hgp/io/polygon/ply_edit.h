// A PLY file with some of its faces turned over or divided, and rows of vertices repeated.
// Role: what --write-repairs needs of PLY; every other byte of the body stays.
#pragma once

#include "hgp/io/polygon/ply_header.h"
#include "hgp/io/polygon/polygon_refine.h"

namespace hgp::io {

/// Copies of vertices follow the last vertex, with all that its row says.
/// @param edited  parents are equal: no vertex is a mean of two
/// Fails with kUnsupported where faces are strips, or the type of their indices is too small.
Result<std::string> editPlyFaces(std::string_view text, const PlyHeader& header,
                                 const RefinedPolygons& edited);

}  // namespace hgp::io
