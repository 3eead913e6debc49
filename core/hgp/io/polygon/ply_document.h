// A PLY document.  Role: writes uv into the original file and leaves everything else unchanged.
#pragma once

#include "hgp/io/polygon/ply_header.h"
#include "hgp/io/polygon/polygon_document.h"

namespace hgp::io {

/// Writes PLY in its own encoding: uv become a list property `texcoord` of the faces with two numbers per corner,
/// so that no vertex must be copied; previous uv (of vertices or faces) are replaced. Triangle strips become faces. The
/// numbers are floats, which other programs read (MeshLab ignores a list of doubles), unless the file has such a list
/// of doubles already. A document that is loaded to be written as PLY is solved for the numbers that it will store; to be
/// written as OBJ, for doubles.
class PlyDocument final : public PolygonDocument {
 public:
  static Result<DocumentPtr> make(Bytes bytes, PlyHeader header, std::size_t textOffset,
                                  PolygonFile file, const std::string& target);
  bool canWriteAs(std::string_view format) const override {
    return format == "obj" || format == "ply";
  }
  UvPrecision uvPrecision() const override {
    return isFloat_ ? UvPrecision::kFloat32 : UvPrecision::kFloat64;
  }
  using Document::asStored;
  UvMap asStored(int surface, const UvMap& map, const std::vector<int>& partOf) const override;
  Result<Written> write(int surface, const UvMap& map, const WriteOptions& options) const override;
  Result<PlainFile> plain(int surface) const override;
  Result<DocumentPtr> repaired(int surface, const FaceEdits& edits) const override;
  Result<DocumentPtr> refined(int surface, const std::vector<VertexPair>& edges) const override;

 private:
  PlyDocument(PlyHeader header, std::size_t textOffset, std::string target);

  Result<DocumentPtr> withFaces(const RefinedPolygons& faces) const;
  VertexExtras extras() const;
  /// As OBJ, with normals and colours.
  Result<Written> writeObj(int surface, const UvMap& map, const WriteOptions& options) const;

  Bytes bytes_;
  PlyHeader header_;
  std::size_t textOffset_ = 0;  ///< offset of the header, after a byte order mark
  std::string target_;          ///< FileSet::target
  bool isFloat_ = false;        ///< maps are rounded to float32
};

}  // namespace hgp::io
