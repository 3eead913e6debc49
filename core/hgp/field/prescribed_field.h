// The trivial connection with exactly the prescribed holonomy, and the cone metric that comes with
// it (Crane, Desbrun, Schröder 2010).  Role: frames and seam rotations of a HolonomySpec; completes
// what the spec leaves open by the smoothest choice.
#pragma once

#include "hgp/base/progress.h"
#include "hgp/field/frame_field.h"
#include "hgp/field/handle_basis.h"
#include "hgp/mesh/holonomy_spec.h"

namespace hgp {

/// What every field of one surface is computed from; build once per surface. A smooth field needs
/// the first four; a prescribed one all.
struct FieldContext {
  Topology topology;
  Geometry geometry;
  linalg::SeparatorTree tree;  ///< of the vertices
  FilledSurface surface;
  SurfaceLaplacian laplacian;
  HandleBasis handles;
};
/// All but the Laplacian and the handles, which take most of the memory.
FieldContext prepareSurface(const TriMesh& mesh);
/// Adds what prepareSurface leaves out.
Status prepareConnection(const TriMesh& mesh, FieldContext& context);
/// Both at once.
Result<FieldContext> prepareFields(const TriMesh& mesh);

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

}  // namespace hgp
