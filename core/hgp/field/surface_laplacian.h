// The Laplacian of the filled surface, factored once.  Role: cone metric, trivial connection and
// harmonic forms all solve with it.
#pragma once

#include <Eigen/Core>

#include "hgp/base/result.h"
#include "hgp/field/filled_surface.h"
#include "hgp/linalg/factor/factor.h"

namespace hgp {

/// (L u)_i = Σ_j w_ij (u_i − u_j), |nodes| × |nodes|, positive semidefinite with the constants as
/// kernel; node 0 (a boundary loop where there is one) is held at 0.
class SurfaceLaplacian {
 public:
  /// Fails with kUnsupported when the weights are not finite.
  /// @param tree  vertexTree(mesh)
  static Result<SurfaceLaplacian> build(const TriMesh& mesh, const FilledSurface& surface,
                                        const linalg::SeparatorTree& tree);

  /// u with L u = rhs (columns; Σ of each column must vanish) and u_0 = 0.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& rhs) const;

 private:
  linalg::MultifrontalCholesky<double> factor_;
};

}  // namespace hgp
