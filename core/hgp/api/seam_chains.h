// Groups seam edges into chains.  Role: the seams as shown to users, one colour each.
#pragma once

#include <cstdint>
#include <vector>

#include "hgp/api/results.h"

namespace hgp::api {

/// The chain of every seam edge, numbered from 0. Two edges are in one chain if they meet at a vertex with exactly
/// two seam edges and have the same rotation r, or r and q − r, because the choice of the first side is arbitrary.
std::vector<std::uint32_t> seamChains(const std::vector<SeamEdge>& seams,
                                      const std::vector<std::uint32_t>& uvToVertex, int q);

}  // namespace hgp::api
