// Components that are images of each other.  Role: one prescription for both, of which one is solved.
#pragma once

#include "hgp/api/request/request.h"

namespace hgp::api {

/// Gives both components of a pair the features of either of them, and the first one the cones of the second if it has none.
/// Fails with kUsage where both have cones that are no images of each other.
/// @param second  has the mirror of the first
Status joinPair(const Model& model, std::size_t second, Request& request);

}  // namespace hgp::api
