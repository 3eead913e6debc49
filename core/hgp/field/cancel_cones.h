// Clean-up of a field's cones.  Role: noisy triangulations give thousands of close opposite pairs;
// what is left must be a prescription that some map has.
#pragma once

#include "hgp/field/prescribed_field.h"

namespace hgp {

/// Radians that frames may turn from one triangle to the next around a vertex, on average.
inline constexpr double kLargestTurnPerEdge = 0.8;

/// Vertices per cone below which cones are the triangulation's noise rather than the surface's.
inline constexpr int kNoiseShare = 50;
/// So few cones are no noise however coarse the mesh.
inline constexpr int kNeverNoise = 24;

struct CancelOptions {
  int reach = 2;        ///< opposite cones at most this many edges apart cancel
  int noiseReach = 6;   ///< … and this many while more than every kNoiseShare-th vertex is a cone
  int targetCount = 0;  ///< > 0: go on cancelling the closest pairs until about this many are left
};

/// Defects q − k per interior vertex → cones that pass checkPrescription: opposite ones cancelled,
/// closest pairs first; k < 1 and k too large for the vertex spread to neighbours; the impossible
/// torus pair cancelled.
///
/// A unit stays where taking it away would leave a vertex more than kLargestTurnPerEdge per incident
/// edge from the curvature it has: a spike needs its cone.
std::vector<ConePoint> cancelCones(const TriMesh& mesh, const FieldContext& context, int q,
                                   PerVertex<int> defect, const CancelOptions& options);

}  // namespace hgp
