// Welds and repairs the surface of a model.  Role: the part of loading that may change connectivity.
#pragma once

#include "hgp/api/model/model.h"

namespace hgp::api {

/// Sets the members of `model` from `mesh` to `isChanged`, its defects and `unusable`, and adds notes: takes the
/// surface from the file, welds it, and repairs it as the options or its defects require.
/// @pre model.document and model.surface are set
void takeRepaired(Model& model, const LoadOptions& options);

void addNotes(Model& model, Notes more);

}  // namespace hgp::api
