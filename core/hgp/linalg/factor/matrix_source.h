// Fronts filled from a sparse matrix.  Role: what the Cholesky classes eliminate.
#pragma once

#include <Eigen/SparseCore>

#include "hgp/linalg/factor/panel_factor.h"

namespace hgp::linalg {

/// The stored columns of A, read through the elimination order; both must outlive the source.
/// @param shift  added to the diagonal
template <class Scalar>
FrontSource<Scalar> matrixSource(const Eigen::SparseMatrix<Scalar>& A, const SymbolicFactor& f,
                                 double shift = 0.0) {
  FrontSource<Scalar> source;
  source.addToPanel = [&A, &f, shift](int t, const int* local, Scalar* panel, int rows) {
    for (int k = f.nodeStart[t]; k < f.nodeStart[t + 1]; ++k) {
      Scalar* column = panel + static_cast<std::size_t>(k - f.nodeStart[t]) * rows;
      for (typename Eigen::SparseMatrix<Scalar>::InnerIterator it(A, f.order[k]); it; ++it) {
        const int p = f.position[it.row()];
        if (p >= k) column[local[p]] += it.value();
      }
      column[local[k]] += shift;
    }
  };
  return source;
}

}  // namespace hgp::linalg
