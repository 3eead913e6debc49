// Groups seam edges into chains.  Role: the seams that users see, one colour each.
#pragma once

#include <cstdint>
#include <vector>

#include "hgp/api/results.h"

namespace hgp::api {

/// The chain of every seam edge, numbered from 0: edges that follow one another at vertices where just two meet,
/// with the same turn r (or q − r, as which side is a is arbitrary).
std::vector<std::uint32_t> seamChains(const std::vector<SeamEdge>& seams,
                                      const std::vector<std::uint32_t>& uvToVertex, int q);

}  // namespace hgp::api
