// Cancels close opposite cones of a field.  Role: noisy triangulations give thousands of them; the remaining cones
// must be a prescription that some map has.
#pragma once

#include "hgp/field/prescribed_field.h"

namespace hgp {

/// Radians that frames may turn from one triangle to the next around a vertex, on average.
inline constexpr double kLargestTurnPerEdge = 0.8;

/// With fewer vertices per cone than this, cones are considered noise of the triangulation.
inline constexpr int kNoiseShare = 50;
/// Up to this many cones are never considered noise, however coarse the mesh.
inline constexpr int kNeverNoise = 24;

struct CancelOptions {
  int reach = 2;       ///< opposite cones at most this many edges apart cancel
  int noiseReach = 6;  ///< the same while more than every kNoiseShare-th vertex is a cone
};

/// Defects q − k per interior vertex → cones that pass checkPrescription: opposite ones cancelled,
/// closest pairs first; k < 1 and k too large for the vertex spread to neighbours; the impossible
/// torus pair cancelled.
///
/// A unit is kept where removing it would leave the vertex with frames that turn by more than kLargestTurnPerEdge per
/// incident edge: a spike needs its cone.
std::vector<ConePoint> cancelCones(const TriMesh& mesh, const FieldContext& context, int q,
                                   PerVertex<int> defect, const CancelOptions& options);

}  // namespace hgp
