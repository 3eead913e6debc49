// The smoothest q-fold symmetric field of a surface.  Role: its singularities are the first choice of automatic cones.
#pragma once

#include "hgp/field/prescribed_field.h"

namespace hgp {

struct SmoothFieldOptions {
  int q = 4;
  bool alignToBoundary = true;    ///< one direction follows every boundary edge (soft constraint)
  bool alignToCurvature = false;  ///< follow principal directions where they are distinct; q even
};

/// Minimises Σ_e w_e |x_g − e^{iqρ} x_f|² for x = e^{iqθ} per face, |x| = 1 on average (smallest
/// eigenvector, by inverse iteration), or with alignment the regularised linear problem; on large
/// meshes first on patches of parallel faces (docs/decisions/017), so that time grows with |F|.
/// Matchings are principal.
/// Fails with kUnsupported where the matrix cannot be factored.
Result<FrameField> smoothField(const TriMesh& mesh, const FieldContext& context,
                               const SmoothFieldOptions& options);

}  // namespace hgp
