// Disks as rectangles.  Role: --boundary rectangle as a prescription: four corners, straight rims, no cones.
#pragma once

#include "hgp/api/options.h"
#include "hgp/api/request/request.h"

namespace hgp::api {

/// Prescribes for every component that its map is a rectangle, with the corners that are given or, where none are, with
/// those of rectangleCorners(). Nothing for other options.
/// Fails with kUnsupported for components that are no disks or have too short a rim, which `keepsGoing` leaves out while
/// there are others, and with kUsage for q ≠ 4, for cones and for corners other than four of 90°.
Status makeRectangles(const Model& model, const SolveOptions& options, Request& request);

}  // namespace hgp::api
