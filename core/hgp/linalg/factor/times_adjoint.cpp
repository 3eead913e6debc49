#include "hgp/linalg/factor/times_adjoint.h"

#include "hgp/linalg/kernels/kernel_workspace.h"

namespace hgp::linalg {

Eigen::MatrixXd timesAdjoint(const Eigen::MatrixXd& A) {
  const int n = static_cast<int>(A.rows()), k = static_cast<int>(A.cols());
  Eigen::MatrixXd C(n, n);
  const KernelWorkspace work;
  kernels().updateReal({n, n, k, A.data(), A.data(), C.data(), n, n, n, true, true}, work.data());
  return -C;
}

Eigen::MatrixXcd timesAdjoint(const Eigen::MatrixXcd& A) {
  const int n = static_cast<int>(A.rows()), k = static_cast<int>(A.cols());
  Eigen::MatrixXcd C(n, n);
  const KernelWorkspace work;
  const auto* from = reinterpret_cast<const double*>(A.data());
  kernels().updateComplex({n, n, k, from, from, raw(C.data()), n, n, n, true, true}, work.data());
  return -C;
}

}  // namespace hgp::linalg
