// An OBJ text taken apart, with the places that a patch has to touch.  Role: one pass at the speed
// of memory; every line stays where it is.
#pragma once

#include <string_view>

#include "hgp/io/document.h"
#include "hgp/io/polygon/polygon_mesh.h"

namespace hgp::io {

/// A run of bytes [begin, end) of the original text.
struct TextSpan {
  std::size_t begin = 0;
  std::size_t end = 0;
};

struct ObjText {
  PolygonMesh polygons;
  std::vector<Vec2> uv;             ///< vt lines in order
  std::vector<int> cornerUv;        ///< per polygon corner, −1 none; empty when no corner has one
  std::vector<TextSpan> faceLines;  ///< one per polygon, continuations and line end included
  std::vector<TextSpan> uvLines;    ///< runs of vt lines
  std::vector<TextSpan> elementLines;  ///< l lines and skipped f lines that name a vt
  std::vector<TextSpan> coneLines;     ///< c and sm lines of the HGP format
  TextSpan embedded;                   ///< our "# hgp-cones {…}" line, or empty
  std::vector<std::string> notes;
};

/// Comment that carries cones inside an OBJ.
inline constexpr std::string_view kEmbeddedConesMark = "# hgp-cones ";

/// Fails with kMalformed and a line number for: a vertex index 0, out of range or relative before its
/// definition; more than kMaxPolygonCorners corners; a line above 1 MiB; a corner without a finite position;
/// anything but decimal numbers; with kLimit above `maxTriangles`. With a note: faces of fewer than three corners are
/// skipped, a vt out of range counts as none, a text without any '\n' has lines that end in '\r'.
Result<ObjText> scanObj(std::string_view text, std::uint64_t maxTriangles);

/// One corner "v", "v/vt", "v//vn" or "v/vt/vn" of a face line, as spelled.
struct ObjCorner {
  std::string_view vertex, uv, normal;
};

/// Takes the next corner at p; false when there is none or it is not well formed.
bool takeObjCorner(const char*& p, const char* end, ObjCorner& corner);

}  // namespace hgp::io
