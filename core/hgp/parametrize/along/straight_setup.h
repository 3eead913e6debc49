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
  std::shared_ptr<RealTree> tree = std::make_shared<RealTree>();
  std::vector<StraightEdge> edges;
  std::vector<SideDistance> distances;
  PerVertex<char> hasRow;
  std::vector<FaceId>
      base;  ///< the triangles at cones off features, and in sectors of index 3 and more
};

/// What the lengths of features depend on, for a field that need not be fitted: all but the metric. Fails with kUnsupported where
/// the equations have no exact solution.
Result<StraightSetup> prepareLengths(PreparedSurface& surface, const std::vector<EdgeId>& features,
                                     AlignedField aligned, const ParametrizeOptions& options,
                                     std::vector<StageTime>& times);

/// What programs need besides, where it is not there yet: the field fitted to its indices, and the scale of the cone metric.
void completeStraight(const TriMesh& mesh, StraightSetup& setup);

/// The same for the smoothest field. Fails as alignedField() does, too.
/// @param features  contain all boundary edges; ascending
/// @param asked     as for alignedField()
Result<StraightSetup> prepareLengths(PreparedSurface& surface, const std::vector<EdgeId>& features,
                                     const HolonomySpec& asked, const ParametrizeOptions& options,
                                     std::vector<StageTime>& times);

/// Both.
Result<StraightSetup> prepareStraight(PreparedSurface& surface, const std::vector<EdgeId>& features,
                                      const HolonomySpec& asked, const ParametrizeOptions& options,
                                      std::vector<StageTime>& times);

inline StraightSystem straightSystemOf(const StraightSetup& setup, const SeamlessSystem& system) {
  return {system, setup.unknowns, setup.edges, setup.distances, setup.hasRow, *setup.tree};
}

}  // namespace hgp
