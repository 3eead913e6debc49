// The uv that are stored for a component without a map.  Role: --keep-going.
#pragma once

#include <string>

#include "hgp/api/model/model.h"
#include "hgp/parametrize/parametrization.h"

namespace hgp::api {

/// The file's uv of the component, or a map of the component cut open to a disk. It is verified against a prescription
/// without cones and never certified, because it is not the prescribed map.
/// @param why  why there is no map    @param isKept  set to true if these are the uv of the file
Parametrization standIn(const Model& model, const ModelComponent& component, int q,
                        const Progress& progress, const std::string& why, bool& isKept);

}  // namespace hgp::api
