// Products of a matrix with its own adjoint.  Role: dense normal equations, computed by the kernels, so that they have
// the same bits on every processor.
#pragma once

#include <Eigen/Core>

namespace hgp::linalg {

/// A Aᴴ; only the lower triangle is defined.
Eigen::MatrixXd timesAdjoint(const Eigen::MatrixXd& A);
Eigen::MatrixXcd timesAdjoint(const Eigen::MatrixXcd& A);

}  // namespace hgp::linalg
