#include "hgp/field/nearest_plane.h"

#include <Eigen/Dense>
#include <cmath>

namespace hgp {

NearestPlane::NearestPlane(const Eigen::MatrixXd& M)
    : U_(Eigen::MatrixXd(M.inverse()).llt().matrixU()) {}

Eigen::VectorXd NearestPlane::round(const Eigen::VectorXd& offset,
                                    const Eigen::VectorXd& step) const {
  Eigen::VectorXd d = offset;
  for (Eigen::Index i = d.size() - 1; i >= 0; --i) {
    double center = 0.0;
    for (Eigen::Index j = i + 1; j < d.size(); ++j) center -= U_(i, j) * d[j] / U_(i, i);
    d[i] += step[i] * std::round((center - d[i]) / step[i]);
  }
  return d;
}

}  // namespace hgp
