// What the programs of a map along features have in common.  Role: features → field → cut → real unknowns.
#pragma once

#include "hgp/features/aligned_field.h"
#include "hgp/optimize/straight_program.h"
#include "hgp/parametrize/seamless_setup.h"

namespace hgp {

struct StraightSetup {
  SeamlessSetup seamless;  ///< its field has the scale of the cone metric with free rims
  AlignedField aligned;
  RealUnknowns unknowns;
  std::vector<StraightEdge> edges;
  std::vector<SideDistance> distances;
  PerVertex<char> hasRow;
  std::vector<FaceId>
      base;  ///< the triangles at cones off features, and in sectors of index 3 and more
};

/// The same for a field that is known, without its stage.
Result<StraightSetup> prepareStraight(PreparedSurface& surface, const std::vector<EdgeId>& features,
                                      AlignedField aligned, const ParametrizeOptions& options,
                                      std::vector<StageTime>& times);

/// Fails as alignedField() does, and with kUnsupported where the equations have no exact solution.
/// @param features  contain all boundary edges; ascending
/// @param asked     as for alignedField()
Result<StraightSetup> prepareStraight(PreparedSurface& surface, const std::vector<EdgeId>& features,
                                      const HolonomySpec& asked, const ParametrizeOptions& options,
                                      std::vector<StageTime>& times);

inline StraightSystem straightSystemOf(const StraightSetup& setup, const SeamlessSystem& system) {
  return {system, setup.unknowns, setup.edges, setup.distances, setup.hasRow};
}

}  // namespace hgp
