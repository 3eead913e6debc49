// A PLY file that can be written again.  Role: uv in, everything else as it was.
#pragma once

#include "hgp/io/polygon/ply_header.h"
#include "hgp/io/polygon/polygon_document.h"

namespace hgp::io {

/// Writes PLY in its own encoding: uv go into a list property `texcoord` of the faces, two doubles a corner,
/// so that vertices stay one; uv that were there before (of vertices or faces) are replaced. Triangle
/// strips become faces.
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
  std::size_t textOffset_ = 0;  ///< behind a byte order mark
};

}  // namespace hgp::io
