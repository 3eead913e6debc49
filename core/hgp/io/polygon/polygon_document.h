// A document with one surface made of polygons, written as OBJ.  Role: the common part of OBJ, OFF, PLY and STL.
#pragma once

#include <string_view>

#include "hgp/io/document.h"
#include "hgp/io/plain_surface.h"
#include "hgp/io/polygon/polygon_mesh.h"
#include "hgp/io/polygon/polygon_refine.h"

namespace hgp::io {

/// The content that the reader of a polygon format extracts.
struct PolygonFile {
  PolygonMesh polygons;
  std::vector<Vec2> uv;       ///< may be empty
  std::vector<int> cornerUv;  ///< per polygon corner, −1 none; empty when there is no uv
  Notes notes;
  int storedVertexCount = -1;  ///< before welding; −1: as many as there are positions
};

class PolygonDocument : public Document {
 public:
  const char* format() const override { return format_; }
  const char* outputFormat() const override { return "obj"; }
  const std::vector<Surface>& surfaces() const override { return surfaces_; }
  UvPrecision uvPrecision() const override { return UvPrecision::kFloat64; }
  std::optional<UvMap> existingUv(int surface, int set) const override;
  std::optional<UvMap> incompleteUv(int surface) const override;
  using Document::asStored;
  UvMap asStored(int surface, const UvMap& map, const std::vector<int>& partOf) const override;
  PolygonsView polygons(int surface) const override;
  Result<std::optional<prescription::Prescription>> embeddedCones(int surface) const override;
  Result<Written> write(int surface, const UvMap& map, const WriteOptions& options) const override;
  Result<DocumentPtr> refined(int surface,
                              const std::vector<std::array<int, 2>>& edges) const override;
  Result<DocumentPtr> repaired(int surface, const FaceEdits& edits) const override;

  Result<PlainFile> plain(int surface) const override;

  /// Triangulates the polygons; fails with kLimit where triangulate() does.
  static Result<DocumentPtr> make(const char* format, PolygonFile file);

 protected:
  explicit PolygonDocument(const char* format) : format_(format) {}
  Status take(PolygonFile file);
  /// The same format with these polygons and the old uv, interpolated.
  Result<DocumentPtr> rewritten(RefinedPolygons refined) const;
  UvMap storedUv() const;
  /// uv index per polygon corner of a map that keeps polygons whole; empty when it does not fit.
  std::vector<int> polygonCornerUv(const UvMap& map) const;

  const char* format_;
  PolygonMesh polygons_;
  TriangleCorners corners_;
  std::vector<Vec2> uv_;
  std::vector<int> cornerUv_;
  std::vector<Surface> surfaces_;
};

/// One per vertex, or none. Colours are fractions, as stored.
struct VertexExtras {
  std::vector<Vec3> normals;
  std::vector<std::array<double, 4>> colors;
};

/// OBJ text of polygons with a uv index per corner (both empty: no vt). Colours follow the positions.
Bytes writePolygonObj(const PolygonMesh& polygons, const std::vector<Vec2>& uv,
                      const std::vector<int>& cornerUv, const WriteOptions& options,
                      const VertexExtras& extras = {});

/// Appends the lines "vt u v" of a map.
void appendUvLines(std::string& out, const std::vector<Vec2>& uv, std::string_view lineEnd);
/// Appends the comment that stores cones in an OBJ.
void appendEmbeddedCones(std::string& out, const WriteOptions& options, std::string_view lineEnd);

inline std::string_view asText(ByteView bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Whether a text begins as an STL text does: comments, then the word "solid" in any case.
bool isStlText(std::string_view text);

/// The text without its UTF-8 byte order mark, if it has one.
inline std::string_view withoutByteOrderMark(std::string_view text) {
  return text.substr(0, 3) == "\xEF\xBB\xBF" ? text.substr(3) : text;
}

}  // namespace hgp::io
