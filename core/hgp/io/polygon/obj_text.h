// The content of an OBJ text, and the positions that a patch must change.  Role: what scanObj() found, without copies
// of its lines.
#pragma once

#include <string_view>

#include "hgp/io/document.h"
#include "hgp/io/polygon/polygon_mesh.h"

namespace hgp::io {

/// The bytes [begin, end) of the original text.
struct TextSpan {
  std::size_t begin = 0;
  std::size_t end = 0;
};

struct ObjText {
  PolygonMesh polygons;
  std::vector<Vec2> uv;             ///< vt lines in order
  std::vector<int> cornerUv;        ///< per polygon corner, −1 none; empty when no corner has one
  std::vector<TextSpan> faceLines;  ///< one per polygon, continuations and line end included
  std::vector<TextSpan> uvLines;    ///< runs of consecutive vt lines
  std::vector<TextSpan> elementLines;  ///< l lines and skipped f lines that name a vt
  std::vector<TextSpan> coneLines;     ///< c and sm lines of the HGP format
  TextSpan embedded;                   ///< our "# hgp-cones {…}" line, or empty
  Notes notes;
};

/// Beginning of the comment that stores cones in an OBJ.
inline constexpr std::string_view kEmbeddedConesMark = "# hgp-cones ";

/// One corner "v", "v/vt", "v//vn" or "v/vt/vn" of a face line, as spelled.
struct ObjCorner {
  std::string_view vertex, uv, normal;
};

/// Reads the next corner at p and advances p; false if there is none or it is not well formed.
bool takeObjCorner(const char*& p, const char* end, ObjCorner& corner);

}  // namespace hgp::io
