// Corner angles of the cone metric to first order.  Role: a start for the search for positive angles, few of which are
// negative.
#pragma once

#include "hgp/field/field_context.h"
#include "hgp/mesh/angle_shortage.h"

namespace hgp {

/// The surface's own corner angles after the flow w (u_i − u_j) from i to j across each inner edge, half of it in each
/// of its triangles: L u = K_asked − K as in prescribedField, so that they sum to what is asked around interior vertices
/// and along the given loops, and to π in a triangle. Other loops take what is left. Negative angles are possible.
/// @pre `context` is complete (prepareConnection)
PerHalfedge<double> coneAngles(const TriMesh& mesh, const FieldContext& context,
                               const AngleQuestion& question);

}  // namespace hgp
