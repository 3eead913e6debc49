// The moves of the strategy: how a map that failed is repaired in the next round. Their order is kMoves in
// loop.cpp.  Role: [BCW17 §7.1] (fixLifts) and the additions of this project, one file each.
#pragma once

#include "hgp/parametrize/strategy/state.h"

namespace hgp {

/// The map has few flipped triangles or none, but other cone angles than prescribed: frames that turn as the map does,
/// corrected by the difference, and then untangling along these frames.
std::optional<State> frameByMap(const Problem&, const State&,
                                const std::shared_ptr<const Attempt>&);

/// Hard constraints with the connection's frames contradict each other or give no map: frames of an angle structure
/// (field/angle_structure.h), whose triangles have the prescribed angles.
std::optional<State> frameByAngles(const Problem&, const State&,
                                   const std::shared_ptr<const Attempt>&);

/// §7.1, frame fixing: cones whose triangles are positive but whose angle is wrong by a multiple of 2π get frames of a
/// ring that is embedded with the right angle (embedConeRing).
std::optional<State> fixLifts(const Problem&, const State&, const std::shared_ptr<const Attempt>&);

/// The harmonic map that frames only chose is wrong: the harmonic map that they constrain on F_cb.
std::optional<State> constrainHarmonic(const Problem&, const State&,
                                       const std::shared_ptr<const Attempt>&);

/// The same with frames of an angle structure.
std::optional<State> harmonicByAngles(const Problem&, const State&,
                                      const std::shared_ptr<const Attempt>&);

/// Frames were soft constraints: hard ones where the map is wrong, and only a patch around these is solved again.
std::optional<State> solvePatch(const Problem&, const State&,
                                const std::shared_ptr<const Attempt>&);

/// The patch made the map worse: a wider patch, starting from the map before it.
std::optional<State> widenPatch(const Problem&, const State&,
                                const std::shared_ptr<const Attempt>&);

/// The constrained set grows by the wrong triangles and a ring around them, within a budget of work.
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
