// From cones to a certified, locally injective, seamless map.  Role: the method of [BCW17 §7]; strategy/loop.cpp
// has the only loop over "solve, verify, choose the next move". Threads may call it at once.
#pragma once

#include "hgp/parametrize/parametrization.h"

namespace hgp {

/// Solves and verifies one connected surface. A map that is not certified is a successful return with
/// isCertified = false. Fails with kPrescription for a prescription that no map can have or given frames that
/// contradict it, with kUsage or kMalformed for given frames that are incomplete, with kLimit and with kCancelled.
/// Deterministic: the result depends only on mesh, prescription and options.
/// @pre mesh has one component
Result<Parametrization> parametrize(const TriMesh& mesh, const HolonomySpec& spec,
                                    const ParametrizeOptions& options);

/// Tutte/Floater: a disk onto a convex polygon (regular, vertices by arc length) with mean-value
/// weights. Fails with kUnsupported when the surface is not a disk, with kUsage for given frames.
Result<Parametrization> parametrizeConvex(const TriMesh& mesh, const ParametrizeOptions& options);

/// parametrizeConvex of the surface cut open to a disk: injective, but not seamless. For surfaces that have no other
/// map (--keep-going). Of `options` only `progress` is used. @pre mesh has one component
Result<UvMap> cutDiskMap(const TriMesh& mesh, const ParametrizeOptions& options);

/// Spacing of automatic cones for a grid with cells of this edge length (units of the surface); for quads, cone angles
/// are also at least 180°.
ConeSpacing roomForGrid(double spacing, GridMode mode, int q);

/// Automatic cones, with turning and handles.
Result<CompleteSpec> suggestCones(const TriMesh& mesh, const SuggestOptions& options);

/// The same two functions for a surface that is kept: later runs reuse what the first one prepared. Solving suggested
/// cones gives the same bits as solving equal cones that the caller prescribes.
class PreparedSurface;
Result<CompleteSpec> suggestCones(PreparedSurface& surface, const SuggestOptions& options,
                                  std::vector<StageTime>* times = nullptr);
Result<Parametrization> parametrize(PreparedSurface& surface, const HolonomySpec& spec,
                                    const ParametrizeOptions& options);

/// The prescription that a given field realises (stored matchings take precedence).
/// @param expected  cones that came with the field; fails with kPrescription where the matchings contradict them
Result<CompleteSpec> readHolonomy(const TriMesh& mesh, const FieldData& field,
                                  const std::vector<ConePoint>& expected = {});

}  // namespace hgp
