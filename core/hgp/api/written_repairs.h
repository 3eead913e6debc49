// Writes repairs into the file.  Role: --write-repairs; from then on the repaired file is solved,
// verified and written.
#pragma once

#include "hgp/api/model.h"

namespace hgp::api {

/// The repairs of `model` as edits of the triangles of its surface. Triangles that were left out and vertices that a
/// weld joined are not changed.
FaceEdits editsOf(const Model& model);

/// "3 faces are written the other way round …"; of edits that are not empty.
std::string noteOn(const FaceEdits& edits, int surfaceVertices);

}  // namespace hgp::api
