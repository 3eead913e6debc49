#include "hgp/optimize/real_program.h"

#include <gtest/gtest.h>

#include <random>

#include "hgp/linalg/ordering/ordering.h"
#include "hgp/optimize/real_form.h"
#include "hgp/socp/iterate.h"
#include "hgp/socp/solve.h"

namespace hgp {
namespace {

using socp::SolveStatus;

linalg::SeparatorTree treeOf(const RealProgram& program) {
  return linalg::nestedDissection(linalg::graphOf(program.H));
}

/// A chain of springs of length 0 between consecutive numbers and from each to 0, without constraints.
RealProgram chain(int n, double pull) {
  RealProgram program;
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n; ++i) {
    entries.emplace_back(i, i, 0.1);
    if (i + 1 == n) break;
    for (const int j : {i, i + 1}) {
      entries.emplace_back(j, j, 1.0);
      entries.emplace_back(j, 2 * i + 1 - j, -1.0);
    }
  }
  program.H = Eigen::SparseMatrix<double>(n, n);
  program.H.setFromTriplets(entries.begin(), entries.end());
  program.c = Eigen::VectorXd::Constant(n, -pull);
  return program;
}

/// sign · x_i ≥ least
socp::ConeConstraint bound(int i, double sign, double least) {
  socp::ConeConstraint out;
  out.unknowns = {i / 2};
  out.F.setZero(3, 2);
  out.F(0, i % 2) = sign;
  out.h[0] = least;
  return out;
}

/// The same program with all constraints at once.
Eigen::VectorXd solvedAtOnce(const RealProgram& program) {
  socp::Problem problem;
  problem.constraints = program.constraints;
  RealForm form(program.H, treeOf(program), problem.constraints);
  problem.form = &form;
  problem.c = form.reduceLinear(program.c);
  return form.extend(socp::solve(problem).x, program.c);
}

int bindingIn(const socp::Solution& solution) {
  return static_cast<int>(std::count_if(solution.y.begin(), solution.y.end(),
                                        [](const Eigen::Vector3d& y) { return y.norm() > 1e-3; }));
}

TEST(RealProgram, WithoutABindingConstraintIsTheMinimiser) {
  RealProgram program = chain(30, 1.0);  // minimiser: 10 everywhere
  program.constraints = {bound(3, 1.0, 2.0), bound(17, -1.0, -50.0)};
  const RealSolution found = solveReal(program, treeOf(program), {});
  EXPECT_EQ(found.solution.status, SolveStatus::kOptimal);
  EXPECT_EQ(found.solution.iterations, 0);
  EXPECT_TRUE(found.solution.isFree);
  EXPECT_EQ(bindingIn(found.solution), 0);
  EXPECT_GT(found.multiplyAdds, 0.0);
  for (int i = 0; i < 30; ++i) EXPECT_NEAR(found.solution.x[i], 10.0, 1e-9);
}

TEST(RealProgram, HasNoConstraintsToo) {
  const RealProgram program = chain(30, 2.0);
  const RealSolution found = solveReal(program, treeOf(program), {});
  EXPECT_EQ(found.solution.status, SolveStatus::kOptimal);
  for (int i = 0; i < 30; ++i) EXPECT_NEAR(found.solution.x[i], 20.0, 1e-9);
}

TEST(RealProgram, TakesInWhatThePointsOfItsPartsViolate) {
  // Held at 10 and pulled up at one place, the chain passes its other bounds only when that is taken in.
  RealProgram program = chain(40, 1.0);
  program.constraints = {bound(20, 1.0, 30.0), bound(21, -1.0, -12.0), bound(19, -1.0, -25.0),
                         bound(2, 1.0, -100.0)};
  const RealSolution found = solveReal(program, treeOf(program), {});
  EXPECT_EQ(found.solution.status, SolveStatus::kOptimal);
  EXPECT_NEAR(found.solution.x[20], 30.0, 1e-3);
  EXPECT_NEAR(found.solution.x[21], 12.0, 1e-3);
  EXPECT_LE(found.solution.x[19], 25.0 + 1e-3);
  EXPECT_EQ(found.solution.y[3].norm(), 0.0);  // far from binding: left out
  EXPECT_GE(bindingIn(found.solution), 2);
  EXPECT_LE((found.solution.x - solvedAtOnce(program)).norm(), 1e-3 * found.solution.x.norm());
}

TEST(RealProgram, IsTheProgramWithAllConstraints) {
  std::mt19937 random(3);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int trial = 0; trial < 20; ++trial) {
    RealProgram program = chain(60, 0.0);
    for (int i = 0; i < 60; ++i) program.c[i] = uniform(-1.0, 1.0);
    for (int b = 0; b < 25; ++b) {  // x = 1 everywhere fulfils all of them
      const int i = static_cast<int>(random() % 60u);
      const double sign = random() % 2u == 0 ? 1.0 : -1.0;
      program.constraints.push_back(bound(i, sign, sign - uniform(0.0, 2.0)));
    }
    socp::ConeConstraint cone;  // x₀ ≥ |(x₁ − 1, x₂ − 1)| / 2
    cone.unknowns = {0, 1};
    cone.F.setZero(3, 4);
    cone.F(0, 0) = 1.0;
    cone.F(1, 1) = cone.F(2, 2) = 0.5;
    cone.h = {0.0, 0.5, 0.5};
    program.constraints.push_back(cone);
    const RealSolution found = solveReal(program, treeOf(program), {});
    EXPECT_TRUE(found.solution.status == SolveStatus::kOptimal ||
                found.solution.status == SolveStatus::kAlmost);
    const Eigen::VectorXd all = solvedAtOnce(program);
    EXPECT_LE((found.solution.x - all).norm(), 1e-2 * (1.0 + all.norm())) << trial;
    for (const socp::ConeConstraint& b : program.constraints)
      EXPECT_GE(socp::depth(socp::image(b, found.solution.x) - b.h), -1e-4) << trial;
  }
}

TEST(RealProgram, NamesTheConstraintsThatContradictEachOther) {
  RealProgram program = chain(30, 1.0);
  program.constraints = {bound(2, 1.0, -5.0), bound(14, 1.0, 12.0), bound(14, -1.0, -11.0),
                         bound(25, 1.0, -7.0)};
  const RealSolution found = solveReal(program, treeOf(program), {});
  EXPECT_EQ(found.solution.status, SolveStatus::kInfeasible);
  EXPECT_EQ(found.solution.y[0].norm(), 0.0);
  EXPECT_GT(found.solution.y[1].norm(), 0.0);
  EXPECT_GT(found.solution.y[2].norm(), 0.0);
  EXPECT_EQ(found.solution.y[3].norm(), 0.0);
}

TEST(RealProgram, IsCancelledByItsProgress) {
  RealProgram program = chain(30, 1.0);
  program.constraints = {bound(3, 1.0, 20.0)};
  const RealSolution found = solveReal(program, treeOf(program), [](int, double) { return false; });
  EXPECT_EQ(found.solution.status, SolveStatus::kCancelled);
}

TEST(RealProgram, WithoutAMinimiserIsNotSolved) {
  RealProgram program = chain(30, 1.0);
  program.H.coeffRef(7, 7) = -1.0;
  program.constraints = {bound(7, 1.0, 0.0)};
  EXPECT_NE(solveReal(program, treeOf(program), {}).solution.status, SolveStatus::kOptimal);
  program.constraints.clear();
  EXPECT_NE(solveReal(program, treeOf(program), {}).solution.status, SolveStatus::kOptimal);
}

}  // namespace
}  // namespace hgp
