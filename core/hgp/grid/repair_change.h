// A change of a map that turns triangles over, solved for again where it does.  Role: the cone program
// of [BCW17 (13)] around a map that is known, translations held.
#pragma once

#include "hgp/base/progress.h"
#include "hgp/grid/strain_form.h"

namespace hgp {

/// Everything that a change is computed from.
struct ChangeContext {
  const TriMesh& mesh;
  const SeamStructure& seams;
  const SeamlessChange& change;
  const std::vector<Vec2>& uv;  ///< the map that is changed
  const StrainWeights& weights;
};

/// Faces that are not positive after the change x.
std::vector<FaceId> turnedFaces(const ChangeContext& context, const Eigen::VectorXcd& x);

/// Minimises the strain over the vertices of `patch` that are free, everything else held as in x,
/// subject to Re f_z − |f_z̄| ≥ ε on `bound`: its frames are those of the map itself, f_z = 1.
/// @param work  multiply-adds of its factorizations are added
/// @return false where there is no such change, the form is singular or `progress` cancels; x is then as
///         before
bool repairChange(const ChangeContext& context, const std::vector<FaceId>& patch,
                  const std::vector<FaceId>& bound, const std::vector<char>& isHeld,
                  Eigen::VectorXcd& x, double& work, const Progress& progress);

/// `faces` and everything within so many rings of vertices, ascending.
std::vector<FaceId> facesAround(const TriMesh& mesh, const std::vector<FaceId>& faces, int rings);
/// The same in parts that have no vertex in common: what happens in one is nothing to the others.
std::vector<std::vector<FaceId>> patchesAround(const TriMesh& mesh,
                                               const std::vector<FaceId>& faces, int rings);

}  // namespace hgp
