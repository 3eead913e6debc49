// The plane of a symmetric map.  Role: SolveOptions::symmetry → ComponentRequest::mirror, and features in the plane.
#pragma once

#include "hgp/api/request/request.h"

namespace hgp::api {

/// Sets the plane of the request and setMirrors(). Fails with kUsage for options that do not go with symmetry, with kUnsupported
/// where the mesh has no such reflection; the message says how far the reflection goes.
Status addMirror(const Model& model, const SolveOptions& options, Request& request);

/// Sets the mirrors of all components for request.plane, if there is one, with the edges in the plane as features (ModelMirror).
Status setMirrors(const Model& model, Request& request);

/// Says that a map is symmetric, which all components' maps and pairs must be. @pre request.plane
Note mirrorNote(const Model& model, const Request& request);

/// Whether edges cross the plane: a map needs edges in it instead.
bool crossesPlane(const Model& model, const Request& request);

}  // namespace hgp::api
