// Corner angles with the sums that a prescription asks for.  Role: how triangles share the angle of cones
// that are close to one another, before any map is known.
#pragma once

#include <optional>

#include "hgp/field/field_context.h"
#include "hgp/mesh/holonomy_spec.h"

namespace hgp {

/// A Euclidean angle structure: θ > 0 per corner, with Σ = π in every triangle, 2πk/q around every interior vertex
/// and, with n boundary vertices, πn − 2πl/q along every loop. A locally injective map has one. Of all of them
/// this is the nearest to the surface's own angles α in relative entropy Σ θ log(θ/α):
///
///   θ_h = π α_h e^{s_v} / Σ_f α e^{s},   s = argmin Σ_f π log(Σ_f α e^{s}) − Σ_v Θ_v s_v,
///
/// found by Newton steps in s, a value per node of the filled surface. The function is convex; its Hessian is the Laplacian with weights
/// θ_i θ_j / π. None where that does not converge, or to angles of 0.
/// @param spec  complete; Lemma 6.2 holds
std::optional<PerHalfedge<double>> angleStructure(const TriMesh& mesh, const FieldContext& context,
                                                  const CompleteSpec& spec);

}  // namespace hgp
