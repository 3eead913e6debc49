// Random prescriptions, uniform over those that pass `check`.  Role: simulates what users might prescribe.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hgp/mesh/holonomy_spec.h"
#include "random.h"

namespace hgp::stress {

enum class Family {
  kRandom,        ///< 3 to 64 cones anywhere, 1 ≤ k < 2q
  kFew,           ///< as few as the genus allows, 3 to 6 on a sphere, half of them on handle loops
  kBig,           ///< k up to 3q, at least one from 2q on
  kAdjacent,      ///< in pairs 1 to 3 edges apart
  kNearBoundary,  ///< at most 2 edges from the boundary
  kHandles,       ///< as kRandom, with every handle rotation prescribed
  kMany,          ///< 100 to 2500 cones anywhere, k = q ± 1; at most every fourth vertex
};
inline constexpr Family kFamilies[] = {Family::kRandom,   Family::kFew,          Family::kBig,
                                       Family::kAdjacent, Family::kNearBoundary, Family::kHandles,
                                       Family::kMany};
/// "random", "few", "big", "adjacent", "near-boundary", "handles", "many"
const char* familyName(Family family);

/// q from 1 to 12; cones at random interior vertices; indices, and turning indices in
/// [−2q, 2q], uniform over the integer vectors that satisfy Lemma 6.2; turning left open in half of
/// the draws, handles in two thirds. Empty if the family does not apply (no boundary, no
/// handle) or 50 draws did not pass checkPrescription.
std::optional<HolonomySpec> draw(const TriMesh& mesh, const Topology& topology, Family family,
                                 Random& random);

}  // namespace hgp::stress
