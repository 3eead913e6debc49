// Given cones, a certified locally injective seamless map.  Role: the page that reads like §7 of
// [BCW17]; the only loop over "try, verify, repair".
#pragma once

#include "hgp/parametrize/parametrization.h"

namespace hgp {

/// Solves and verifies one connected surface. A map that is not certified is a successful return with
/// isCertified = false; failures are prescriptions that cannot be, given frames that contradict the
/// prescription (kPrescription) or are none (kUsage, kMalformed), limits and cancellation.
/// The road depends on mesh, prescription and options alone.
/// @pre mesh has one component
Result<Parametrization> parametrize(const TriMesh& mesh, const HolonomySpec& spec,
                                    const ParametrizeOptions& options);

/// Tutte/Floater: a disk onto a convex polygon (regular, vertices by arc length) with mean-value
/// weights. Fails with kUnsupported when the surface is not a disk, with kUsage for given frames.
Result<Parametrization> parametrizeConvex(const TriMesh& mesh, const ParametrizeOptions& options);

/// The surface cut open to a disk, and that by parametrizeConvex: injective, but its seams fit nowhere. For what
/// has no other map. Of `options` only the progress counts. @pre mesh has one component
Result<UvMap> cutDiskMap(const TriMesh& mesh, const ParametrizeOptions& options);

/// Room between automatic cones for a grid of this spacing, and for quads two edges at each at least.
ConeSpacing roomForGrid(double spacing, GridMode mode, int q);

/// Cones, turning and handles by themselves ("automatic cones").
Result<CompleteSpec> suggestCones(const TriMesh& mesh, const SuggestOptions& options);

/// Both again for a surface that is kept: what one run prepared, the next ones use. What was suggested
/// and is then solved gives the map of the same cones named by anybody else, to the last bit.
class PreparedSurface;
Result<CompleteSpec> suggestCones(PreparedSurface& surface, const SuggestOptions& options,
                                  std::vector<StageTime>* times = nullptr);
Result<Parametrization> parametrize(PreparedSurface& surface, const HolonomySpec& spec,
                                    const ParametrizeOptions& options);

/// The prescription that a given field has, exactly (stored matchings are the truth). `expected`: cones
/// that came along; refused when the matchings contradict them.
Result<CompleteSpec> readHolonomy(const TriMesh& mesh, const FieldData& field,
                                  const std::vector<ConePoint>& expected = {});

}  // namespace hgp
