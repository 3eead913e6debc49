// What is stored of a component that has no map.  Role: --keep-going.
#pragma once

#include <string>

#include "hgp/api/model.h"
#include "hgp/parametrize/parametrization.h"

namespace hgp::api {

/// The uv that the file has for the component, or the component cut open to a disk. Verified by a prescription
/// without cones and never certified, however sound, as it is not what was asked for.
/// @param why  there is no map    @param isKept  set: it is the uv that the file has
Parametrization standIn(const Model& model, const ModelComponent& component, int q,
                        const Progress& progress, const std::string& why, bool& isKept);

}  // namespace hgp::api
