// The moves of the strategy, in the order they are looked through.  Role: [BCW17 §7.1] and what this
// project adds to it; each in a file of its own.
#pragma once

#include "hgp/parametrize/strategy.h"

namespace hgp {

/// A map without a flipped triangle but with other cones than asked: frames that turn as it does, but for the
/// difference, and along them no flip but the right cones (untangle).
std::optional<State> frameByMap(const Problem&, const State&,
                                const std::shared_ptr<const Attempt>&);

/// Where hard constraints of the connection's frames contradict each other or give no map: frames of triangles with the
/// angles that cones ask for.
std::optional<State> frameByAngles(const Problem&, const State&,
                                   const std::shared_ptr<const Attempt>&);

/// §7.1: cones with a positive ring whose angle is off by a multiple of 2π get a ring embedded from the map.
std::optional<State> fixLifts(const Problem&, const State&, const std::shared_ptr<const Attempt>&);

/// Where frames are soft: hard ones where the map is wrong, and only a patch around it solved again.
std::optional<State> solvePatch(const Problem&, const State&,
                                const std::shared_ptr<const Attempt>&);

/// A patch that made it worse: from the map before, with a wider one.
std::optional<State> widenPatch(const Problem&, const State&,
                                const std::shared_ptr<const Attempt>&);

/// The constrained set grows by what is wrong and a ring around it, within a budget of work.
std::optional<State> enlarge(const Problem&, const State&, const std::shared_ptr<const Attempt>&);

/// No frames at all: the next kind of untangling, within a budget of Newton steps.
std::optional<State> untangleNext(const Problem&, const State&,
                                  const std::shared_ptr<const Attempt>&);

/// The next weighting, from the connection's frames on F_cb.
std::optional<State> nextWeighting(const Problem&, const State&,
                                   const std::shared_ptr<const Attempt>&);

/// Method::kPrinted: frames and weights of the map before (§7, last paragraph).
std::optional<State> iterateFrames(const Problem&, const State&,
                                   const std::shared_ptr<const Attempt>&);

}  // namespace hgp
