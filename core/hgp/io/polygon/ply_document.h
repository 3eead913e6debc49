// A PLY document.  Role: writes uv into the original file and leaves everything else unchanged.
#pragma once

#include "hgp/io/polygon/ply_header.h"
#include "hgp/io/polygon/polygon_document.h"

namespace hgp::io {

/// Writes PLY in its own encoding: uv become a list property `texcoord` of the faces with two doubles per corner,
/// so that no vertex must be copied; previous uv (of vertices or faces) are replaced. Triangle strips become faces.
class PlyDocument final : public PolygonDocument {
 public:
  static Result<DocumentPtr> make(Bytes bytes, PlyHeader header, std::size_t textOffset,
                                  PolygonFile file);
  bool canWriteAs(std::string_view format) const override {
    return format == "obj" || format == "ply";
  }
  Result<Written> write(int surface, const UvMap& map, const WriteOptions& options) const override;
  Result<PlainFile> plain(int surface) const override;
  Result<DocumentPtr> repaired(int surface, const FaceEdits& edits) const override;

 private:
  PlyDocument() : PolygonDocument("ply") {}

  Bytes bytes_;
  PlyHeader header_;
  std::size_t textOffset_ = 0;  ///< offset of the header, after a byte order mark
};

}  // namespace hgp::io
