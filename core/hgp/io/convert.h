// Converts a file to another format before it is read.  Role: makes `-o x.glb` possible for an OBJ.
#pragma once

#include "hgp/io/document.h"

namespace hgp::io {

/// Whether convertFiles produces this format: "obj" from glTF; "glb" from polygon formats and from .gltf; "gltf"
/// from polygon formats (as a GLB, which Document::write stores as a .gltf).
bool canConvert(const Document& document, std::string_view format);

/// The files of a document in that format. Notes say what is not kept.
/// `surface` as for Document::plain. @pre canConvert
Result<FileSet> convertFiles(const Document& document, const FileSet& files,
                             std::string_view format, int surface, const Limits& limits);

}  // namespace hgp::io
