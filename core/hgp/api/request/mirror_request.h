// The plane of a symmetric map.  Role: SolveOptions::symmetry → ComponentRequest::mirror, and features in the plane.
#pragma once

#include "hgp/api/request/request.h"

namespace hgp::api {

/// Sets the mirror of every component, with the edges in the plane as features, and a note on the plane. Fails with kUsage for
/// options that do not go with symmetry, with kUnsupported where the mesh has no such reflection, or no edges where its
/// plane is; the message says how far the reflection goes.
Status addMirror(const Model& model, const SolveOptions& options, Request& request);

}  // namespace hgp::api
