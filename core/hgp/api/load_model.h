// From bytes to a model.  Role: read, converted where asked, welded, repaired, split into components.
#pragma once

#include "hgp/api/model.h"

namespace hgp::api {

/// Fails for unreadable files, limits and a surface that is not there; an unusable mesh is a success
/// with `unusable` set.
Result<Model> loadModel(io::FileSet files, const LoadOptions& options);
Result<Model> modelOfArrays(MeshData arrays, const LoadOptions& options);
/// A document that is open already.
Result<Model> modelOfDocument(io::DocumentPtr document, const LoadOptions& options);

}  // namespace hgp::api
