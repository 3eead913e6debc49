// The scale of a map along features.  Role: weights of its program; the cone metric with free rims.
#pragma once

#include "hgp/features/aligned_field.h"

namespace hgp {

/// u with L u = K_asked − K, K_asked = 2π − kπ/2 at inner vertices and π − Σ a π/2 on rims, Σ over the sectors of a
/// vertex; L with cotangent weights, clamped positive, without conditions on rims. The median of u is 0. Zero where
/// the matrix cannot be factored.
PerVertex<double> coneScale(const TriMesh& mesh, const FieldContext& context,
                            const AlignedField& field);

}  // namespace hgp
