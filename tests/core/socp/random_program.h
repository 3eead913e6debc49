// Small random cone programs with a fixed seed.  Role: what our solver and an outside one are both
// given.
#pragma once

#include <Eigen/Dense>

#include "hgp/base/check.h"
#include "hgp/base/turns.h"
#include "hgp/socp/solve.h"
#include "support/random.h"

namespace hgp::test {

struct RandomProgram {
  Eigen::SparseMatrix<Complex> H;
  Eigen::VectorXcd c;
  std::vector<std::vector<int>> cliques;
  std::vector<Eigen::MatrixXd> F;
  std::vector<Eigen::Vector3d> h;

  Eigen::MatrixXd realH() const {
    const Eigen::Index n = H.rows();
    const Eigen::MatrixXcd dense(H);
    Eigen::MatrixXd real(2 * n, 2 * n);
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index j = 0; j < n; ++j) {
        real(2 * i, 2 * j) = real(2 * i + 1, 2 * j + 1) = dense(i, j).real();
        real(2 * i, 2 * j + 1) = -dense(i, j).imag();
        real(2 * i + 1, 2 * j) = dense(i, j).imag();
      }
    return real;
  }
  Eigen::VectorXd realC() const {
    return Eigen::Map<const Eigen::VectorXd>(reinterpret_cast<const double*>(c.data()),
                                             2 * c.size());
  }
  /// Rows of constraint b over all real unknowns.
  Eigen::MatrixXd fullF(std::size_t b) const {
    Eigen::MatrixXd full = Eigen::MatrixXd::Zero(3, 2 * H.rows());
    for (std::size_t i = 0; i < cliques[b].size(); ++i)
      full.middleCols<2>(2 * cliques[b][i]) = F[b].middleCols<2>(static_cast<Eigen::Index>(2 * i));
    return full;
  }
};

/// n complex unknowns, a Hermitian positive definite H of a random graph, and cones around a point
/// that is strictly feasible.
inline RandomProgram randomProgram(unsigned seed) {
  std::mt19937 random(seed);
  const int n = 4 + randomBelow(random, 12), count = 1 + randomBelow(random, 8);
  const auto any = [&] { return Complex(randomReal(random), randomReal(random)); };
  RandomProgram p;
  Eigen::MatrixXcd rows = Eigen::MatrixXcd::Zero(2 * n, n);
  for (int r = 0; r < n; ++r) rows(r, r) = 0.3 + std::abs(randomReal(random));
  for (int r = n; r < 2 * n; ++r)
    for (int e = 0; e < 3; ++e) rows(r, randomBelow(random, n)) += any();
  p.H = Eigen::MatrixXcd(rows.adjoint() * rows).sparseView();
  p.c.resize(n);
  for (Complex& value : p.c) value = 3.0 * any();
  Eigen::VectorXd inside(2 * n);
  for (double& value : inside) value = 2.0 * randomReal(random);
  for (int b = 0; b < count; ++b) {
    std::vector<int> clique;
    for (int j = 0; j < n; ++j)
      if (randomBelow(random, n) < 3) clique.push_back(j);
    if (clique.empty()) clique.push_back(randomBelow(random, n));
    Eigen::MatrixXd F(3, static_cast<Eigen::Index>(2 * clique.size()));
    for (double& value : F.reshaped()) value = randomReal(random);
    p.cliques.push_back(clique);
    p.F.push_back(F);
    p.h.emplace_back(Eigen::Vector3d::Zero());
    Eigen::Vector3d s = p.fullF(p.cliques.size() - 1) * inside;
    s[0] -= std::hypot(s[1], s[2]) + 0.05 + std::abs(randomReal(random));
    p.h.back()[0] = s[0];  // F·inside − h is inside the cone by a little
  }
  return p;
}

struct Solved {
  socp::Solution solution;
  Eigen::VectorXd x;  ///< all real unknowns
};

inline Solved solveProgram(const RandomProgram& p, const socp::SolveOptions& options = {}) {
  linalg::PartialCholesky form;
  HGP_CHECK(form.build(p.H, p.cliques), "H is positive definite");
  const Eigen::VectorXcd reduced = form.reduceLinear(p.c);
  socp::Problem problem;
  problem.form = &form;
  problem.c = Eigen::Map<const Eigen::VectorXd>(reinterpret_cast<const double*>(reduced.data()),
                                                2 * reduced.size());
  for (std::size_t b = 0; b < p.cliques.size(); ++b) {
    socp::ConeConstraint constraint;
    for (int j : p.cliques[b]) constraint.unknowns.push_back(form.dynamicIndex(j));
    constraint.F = p.F[b];
    constraint.h = p.h[b];
    problem.constraints.push_back(constraint);
  }
  Solved solved{socp::solve(problem, options), {}};
  const Eigen::VectorXcd x = form.extend(solved.solution.x, p.c);
  solved.x =
      Eigen::Map<const Eigen::VectorXd>(reinterpret_cast<const double*>(x.data()), 2 * x.size());
  return solved;
}

}  // namespace hgp::test
