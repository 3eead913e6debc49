// Repairs a change of a map that flips triangles, by solving again around these.  Role: the cone program
// of [BCW17 (13)] with the frames of a known map and held translations.
#pragma once

#include "hgp/base/progress.h"
#include "hgp/grid/strain_form.h"
#include "hgp/mesh/face_rings.h"

namespace hgp {

/// Faces that are not positive after the change x.
std::vector<FaceId> turnedFaces(const ChangeContext& context, const Eigen::VectorXcd& x);
/// The signed area of the map after the change x.
double changedArea(const ChangeContext& context, const Eigen::VectorXcd& x);

/// Minimises the strain over the vertices of `patch` that are free, everything else held as in x,
/// subject to Re f_z − |f_z̄| ≥ ε on `bound`: its frames are those of the map itself, f_z = 1.
/// @param work  the multiply-adds of the factorizations are added to it
/// @return false where there is no such change, the form is singular or `progress` cancels; x is then
///         unchanged
bool repairChange(const ChangeContext& context, const std::vector<FaceId>& patch,
                  const std::vector<FaceId>& bound, const std::vector<char>& isHeld,
                  Eigen::VectorXcd& x, double& work, const Progress& progress);

}  // namespace hgp
