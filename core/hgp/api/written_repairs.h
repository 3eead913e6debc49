// Repairs on their way into the file.  Role: --write-repairs; the repaired file is what is solved,
// verified and written from then on.
#pragma once

#include "hgp/api/model.h"

namespace hgp::api {

/// What the repairs of `model` are on the triangles of its surface. Left out triangles stay as they are,
/// and so do vertices that a weld joined.
FaceEdits editsOf(const Model& model);

/// "3 faces are written the other way round …"; of edits that are not empty.
std::string noteOn(const FaceEdits& edits, int surfaceVertices);

}  // namespace hgp::api
