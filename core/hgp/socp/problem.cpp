#include "hgp/socp/problem.h"

#include <utility>

namespace hgp::socp {

Eigen::VectorXd reducedLinear(const linalg::PartialCholesky& form, const Eigen::VectorXcd& c) {
  const Eigen::VectorXcd reduced = form.reduceLinear(c);
  return Eigen::Map<const Eigen::VectorXd>(reinterpret_cast<const double*>(reduced.data()),
                                           2 * reduced.size());
}

Problem problemOver(linalg::PartialCholesky& form, const Eigen::VectorXcd& c) {
  Problem problem;
  problem.form = &form;
  problem.c = reducedLinear(form, c);
  return problem;
}

void append(ConeConstraint constraint, const std::vector<int>& unknowns,
            const linalg::PartialCholesky& form, Problem& problem) {
  constraint.unknowns.clear();
  for (const int unknown : unknowns) constraint.unknowns.push_back(form.dynamicIndex(unknown));
  problem.constraints.push_back(std::move(constraint));
}

}  // namespace hgp::socp
