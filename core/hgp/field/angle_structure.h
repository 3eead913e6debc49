// An angle structure: corner angles with the sums that a prescription asks for.  Role: shapes of triangles, and
// frames, between cones that are close to one another, before any map is known.
#pragma once

#include <optional>

#include "hgp/field/field_context.h"
#include "hgp/mesh/holonomy_spec.h"

namespace hgp {

/// A Euclidean angle structure: θ > 0 per corner (radians), with Σ = π in every triangle, 2πk/q around every interior
/// vertex and, with n boundary vertices, πn − 2πl/q along every loop. Every locally injective map has one. This is the
/// one nearest to the surface's own angles α in relative entropy Σ θ log(θ/α):
///
///   θ_h = π α_h e^{s_v} / Σ_f α e^{s},   s = argmin Σ_f π log(Σ_f α e^{s}) − Σ_v Θ_v s_v,
///
/// found by Newton's method in s, one value per node of the filled surface. The function is convex; its Hessian is the
/// Laplacian with weights θ_i θ_j / π. Empty where that does not converge, or converges to angles of 0.
/// @param spec  complete; Lemma 6.2 holds
std::optional<PerHalfedge<double>> angleStructure(const TriMesh& mesh, const FieldContext& context,
                                                  const CompleteSpec& spec);

}  // namespace hgp
