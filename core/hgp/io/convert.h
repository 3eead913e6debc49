// One format read as if it had been another.  Role: what makes `-o x.glb` of an OBJ possible.
#pragma once

#include "hgp/io/document.h"

namespace hgp::io {

/// Whether convertFiles makes this format: "obj" from glTF, "glb" from any other and from .gltf, "gltf" from
/// any other (as a GLB, which Document::write takes apart).
bool canConvert(const Document& document, std::string_view format);

/// The files of a document as if they had been of that format. Notes say what is not kept.
/// `surface` as for Document::plain. @pre canConvert
Result<FileSet> convertFiles(const Document& document, const FileSet& files,
                             std::string_view format, int surface, const Limits& limits);

}  // namespace hgp::io
