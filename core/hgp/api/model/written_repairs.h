// Writes repairs into the file.  Role: --write-repairs; from then on the repaired file is solved,
// verified and written.
#pragma once

#include "hgp/api/model/model.h"

namespace hgp::api {

/// The repairs of `model` as edits of the triangles of its surface. Triangles that were left out and vertices that
/// were welded are not changed.
FaceEdits editsOf(const Model& model);

/// The note on these edits, "3 faces are written …". @pre edits.faces is not empty
Note noteOn(const FaceEdits& edits, int surfaceVertices);

}  // namespace hgp::api
