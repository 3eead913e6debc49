// Clean-up of a field's cones.  Role: noisy triangulations give thousands of close opposite pairs;
// what is left must be a prescription that some map has.
#pragma once

#include "hgp/field/prescribed_field.h"

namespace hgp {

struct CancelOptions {
  int reach = 6;        ///< opposite cones at most this many edges apart cancel
  int targetCount = 0;  ///< > 0: go on cancelling the closest pairs until about this many are left
};

/// Defects q − k per interior vertex → cones that pass checkPrescription: opposite ones cancelled,
/// closest pairs first; k < 1 and k too large for the vertex spread to neighbours; the impossible
/// torus pair cancelled.
std::vector<ConePoint> cancelCones(const TriMesh& mesh, const Topology& topology, int q,
                                   PerVertex<int> defect, const CancelOptions& options);

}  // namespace hgp
