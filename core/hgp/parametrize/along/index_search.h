// Other cones and corners where those of the field have no map along features.  Role: the lengths of features are a linear
// program over Γ alone, cheap enough to be asked after every move of a unit of index (docs/decisions/095).
#pragma once

#include "hgp/parametrize/along/straight_setup.h"

namespace hgp {

struct IndexSearch {
  std::optional<AlignedField>
      field;      ///< nothing if none was found, or if what is asked of it is not the obstacle
  int moves = 0;  ///< units that were moved
  bool isCancelled = false;
};

/// What is asked of a field: that every feature edge can have a positive length and no triangle is flat whatever the map
/// (fitLengths); or, beyond that, that the map of the program without frames is certified. That also sees lengths
/// between cones, which are no linear program, and costs a program per field: on small surfaces only.
enum class IndexGoal { kLengths, kMap };

/// Moves units of index between corners, or between corners and inner vertices, as cheaply as it can (index_flow.h), while
/// each move brings the field nearer to the goal: a smaller excess of lengths, fewer wrong triangles and angles.
/// @param setup  of a field that does not reach it
IndexSearch searchIndices(PreparedSurface& surface, const StraightSetup& setup, IndexGoal goal,
                          const ParametrizeOptions& options);

}  // namespace hgp
