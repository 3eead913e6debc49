// Documents that are not read directly from a file: conversions to another format, and arrays.  Role: a part of
// loading.
#pragma once

#include "hgp/api/options.h"

namespace hgp::api {

struct ConvertedDocument {
  io::DocumentPtr document;
  Notes notes;
  /// Whether vertex ids and triangle ids are those of the file that was read.
  bool hasOwnVertexIds = true, hasOwnFaceIds = true;
};

/// The document converted to options.target by io::convertFiles. @pre io::canConvert
Result<ConvertedDocument> convertDocument(const io::Document& before, const io::FileSet& files,
                                          const LoadOptions& options);

/// A document of the given arrays. Fails with kMalformed for an index that is not a vertex.
Result<io::DocumentPtr> documentOfArrays(MeshData arrays);

}  // namespace hgp::api
