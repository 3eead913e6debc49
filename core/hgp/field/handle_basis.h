// Harmonic 1-forms of the filled surface, one per handle generator.  Role: the part of a trivial
// connection that sets the holonomy of handles.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "hgp/field/surface_laplacian.h"

namespace hgp {

/// Form i is ξ_i = ξ⁰_i + d f_i on primal halfedges (from tail to head), closed on faces and
/// co-closed at nodes; ξ⁰_i counts crossings of generator i. A connection adjustment is w ξ.
struct HandleBasis {
  std::vector<DualLoop> loops;  ///< handleGenerators(mesh)
  Eigen::MatrixXd potential;    ///< f_i, |nodes| × 2g
  Eigen::MatrixXd periods;  ///< ⟨ξ_i, ξ_j⟩_w = ∮_j w ξ_i, 2g × 2g, symmetric positive definite
};

HandleBasis computeHandleBasis(const TriMesh& mesh, const FilledSurface& surface,
                               const SurfaceLaplacian& laplacian);

/// Σ c_i ξ_i per halfedge of smaller index on each edge (antisymmetric on the twin).
PerEdge<double> combineForms(const TriMesh& mesh, const FilledSurface& surface,
                             const HandleBasis& basis, const Eigen::VectorXd& c);

}  // namespace hgp
