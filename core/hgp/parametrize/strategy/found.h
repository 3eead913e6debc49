// The maps that a search has found, and which of them is delivered.
#pragma once

#include <memory>

#include "hgp/parametrize/strategy/state.h"

namespace hgp {

/// Of the maps so far, `best` is to be delivered; of the harmonic ones that are certified, `harmonic` has the least μ. The
/// paper's weights go before others, and harmonic maps before all others, where μ is not much larger.
struct Found {
  std::shared_ptr<const Attempt> best, harmonic;
  std::shared_ptr<const Attempt> unfolded;  ///< certified with its own cones, the fewest wrong

  void add(const std::shared_ptr<const Attempt>& attempt, bool isHarmonic);
};

/// The mean of μ over the area of the map.
double meanMuOf(const Attempt& attempt);

}  // namespace hgp
