// Loads a model from bytes.  Role: reads, converts on request, welds, repairs and splits into components.
#pragma once

#include "hgp/api/model/model.h"

namespace hgp::api {

/// Fails for unreadable files, exceeded limits and a surface that does not exist. An unusable mesh is a success
/// with `unusable` set.
Result<Model> loadModel(io::FileSet files, const LoadOptions& options);
/// The two steps of loadModel: read and convert, and take the mesh options.surface.
Result<OpenedFile> openFile(io::FileSet files, const LoadOptions& options);
Result<Model> modelOfFile(OpenedFile file, const LoadOptions& options);
Result<Model> modelOfArrays(MeshData arrays, const LoadOptions& options);
/// The same for a document that is already open.
Result<Model> modelOfDocument(io::DocumentPtr document, const LoadOptions& options);

}  // namespace hgp::api
