// Reads an OBJ text.  Role: one fast pass, in several threads where it is long.
#pragma once

#include "hgp/io/polygon/obj_text.h"

namespace hgp::io {

/// Fails with kMalformed and a line number for: a vertex index that is 0, out of range, or relative to a vertex
/// before the first; more than kMaxPolygonCorners corners; a line above 1 MiB; a corner without a finite position;
/// anything but decimal numbers. Fails with kLimit above `maxTriangles`. Accepted with a note: faces with fewer than
/// three corners are skipped, a vt out of range counts as none, and in a text without '\n' lines end in '\r'.
Result<ObjText> scanObj(std::string_view text, std::uint64_t maxTriangles);

}  // namespace hgp::io
