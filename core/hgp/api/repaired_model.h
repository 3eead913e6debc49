// The surface of a model with its welds and repairs made.  Role: the part of loading that may change
// connectivity.
#pragma once

#include "hgp/api/model.h"

namespace hgp::api {

/// Sets everything of `model` from `mesh` to `isChanged`, its defects, `unusable`, and adds notes: the
/// surface as the file has it, welded, and repaired as the options or its defects ask.
/// @pre model.document and model.surface are set
void takeRepaired(Model& model, const LoadOptions& options);

void addNotes(Model& model, std::vector<std::string> more);

}  // namespace hgp::api
