// Completes the turning indices that a prescription leaves open.  Role: the first step of a trivial connection.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "hgp/base/result.h"
#include "hgp/field/field_context.h"
#include "hgp/mesh/holonomy_spec.h"

namespace hgp {

/// K_asked − K per node of the filled surface, for cones and given turning; open loops get nothing.
Eigen::VectorXd curvatureGap(const FilledSurface& surface, const HolonomySpec& spec);

/// l_j of all loops. Open ones take those of the cone metric in which u is equal on all of them,
/// rounded to the nearest integers that balance Gauss–Bonnet (Lemma 6.2) within the turningRange of each
/// loop. Fails with kPrescription where there are none.
Result<std::vector<int>> completeTurning(const TriMesh& mesh, const FieldContext& context,
                                         const HolonomySpec& spec);

}  // namespace hgp
