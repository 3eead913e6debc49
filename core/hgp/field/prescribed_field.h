// The trivial connection with exactly the prescribed holonomy, and the cone metric that comes with
// it (Crane, Desbrun, Schröder 2010).  Role: frames and seam rotations of a HolonomySpec; completes
// what the spec leaves open by the smoothest choice.
#pragma once

#include <vector>

#include "hgp/base/progress.h"
#include "hgp/field/field_context.h"
#include "hgp/field/frame_field.h"
#include "hgp/mesh/holonomy_spec.h"

namespace hgp {

struct PrescribedField {
  FrameField field;  ///< matchings realise `spec` exactly
  CompleteSpec spec;
  PerVertex<double> u;       ///< log conformal factor of the cone metric, L u = K_asked − K
  double scaleRange = 0.0;   ///< max u − min u
  double largestTurn = 0.0;  ///< largest |adjustment| across an edge, radians
};

/// Adjustment across h from face(h) to its twin's: ω = w (u_head − u_tail) + w Σ c_i ξ_i, so that
/// around a node Σ ω = K_asked − K and along generator j the transport turns by 2πr_j/q.
/// Turning indices left open are the nearest integers to those of the cone metric with u equal on
/// the open loops; handles left open are rounded to the smoothest connection.
/// Fails with kPrescription when no admissible turning indices balance Lemma 6.2.
/// @pre checkPrescription(spec) passed; one component
Result<PrescribedField> prescribedField(const TriMesh& mesh, const FieldContext& context,
                                        const HolonomySpec& spec);

/// Other rotations of all handles: one that `asked` leaves open is a step of 2π/q away from that of `chosen`. Smoothest
/// connection first; empty where none is open or q = 1.
/// @param chosen  prescribedField(asked).spec
std::vector<std::vector<int>> otherHandles(const TriMesh& mesh, const FieldContext& context,
                                           const HolonomySpec& asked, const CompleteSpec& chosen);

}  // namespace hgp
