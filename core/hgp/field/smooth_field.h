// The smoothest q-fold symmetric field of a surface.  Role: its singularities are the first choice of automatic cones.
#pragma once

#include "hgp/field/prescribed_field.h"

namespace hgp {

/// One direction of the field in a triangle, radians in the triangle's coordinates.
struct HeldDirection {
  FaceId face;
  double angle = 0.0;
};

struct SmoothFieldOptions {
  int q = 4;
  bool alignToBoundary = true;    ///< one direction follows every boundary edge (soft constraint)
  bool alignToCurvature = false;  ///< follow principal directions where they are distinct; q even
  std::vector<HeldDirection> held = {};  ///< these triangles have exactly these directions
};

/// Minimises Σ_e w_e |x_g − e^{iqρ} x_f|² for x = e^{iqθ} per face, |x| = 1 on average (smallest
/// eigenvector, by inverse iteration), or with alignment the regularised linear problem; on large
/// meshes first on patches of parallel faces (docs/decisions/017), so that time grows with |F|.
/// Matchings are principal.
/// Fails with kUnsupported where the matrix cannot be factored.
Result<FrameField> smoothField(const TriMesh& mesh, const FieldContext& context,
                               const SmoothFieldOptions& options);

}  // namespace hgp
