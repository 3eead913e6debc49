// Documents that no reader made: of another format than the file's, and of arrays.  Role: a part of
// loading.
#pragma once

#include "hgp/api/options.h"

namespace hgp::api {

struct ConvertedDocument {
  io::DocumentPtr document;
  std::vector<std::string> notes;
  /// Whether ids of vertices and of triangles are those of the file that was read.
  bool hasOwnVertexIds = true, hasOwnFaceIds = true;
};

/// What io::convertFiles makes of it for options.target. @pre io::canConvert
Result<ConvertedDocument> convertDocument(const io::Document& before, const io::FileSet& files,
                                          const LoadOptions& options);

/// A document of triangles that come from no file. Fails with kMalformed for an index that names no vertex.
Result<io::DocumentPtr> documentOfArrays(MeshData arrays);

}  // namespace hgp::api
