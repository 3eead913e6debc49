#include "hgp/socp/solve.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/socp/random_program.h"
#include "hgp/socp/second_order_cone.h"

namespace hgp {
namespace {

using socp::SolveStatus;

/// minimise ½|x − a|² over one complex unknown, under the given rows.
test::RandomProgram projection(Complex a, const std::vector<Eigen::MatrixXd>& F,
                               const std::vector<Eigen::Vector3d>& h) {
  test::RandomProgram p;
  p.H.resize(1, 1);
  p.H.insert(0, 0) = 1.0;
  p.c = Eigen::VectorXcd::Constant(1, -a);
  p.F = F;
  p.h = h;
  p.cliques.assign(F.size(), {0});
  return p;
}

Eigen::MatrixXd rows(std::initializer_list<double> values) {
  Eigen::MatrixXd F(3, 2);
  auto value = values.begin();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 2; ++j) F(i, j) = *value++;
  return F;
}

TEST(ConeProgram, ProjectsOntoAWedge) {
  // x ≥ |y|: beside the wedge the nearest point lies on its edge, behind its tip it is the tip.
  const Eigen::MatrixXd wedge = rows({1, 0, 0, 1, 0, 0});
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  const std::pair<Complex, Complex> cases[] = {
      {{3, 1}, {3, 1}}, {{1, 3}, {2, 2}}, {{1, -3}, {2, -2}}, {{-4, 1}, {0, 0}}};
  for (const auto& [from, to] : cases) {
    const test::Solved solved = test::solveProgram(projection(from, {wedge}, {zero}));
    EXPECT_EQ(solved.solution.status, SolveStatus::kOptimal) << from;
    EXPECT_NEAR(solved.x[0], to.real(), 1e-3) << from;
    EXPECT_NEAR(solved.x[1], to.imag(), 1e-3) << from;
  }
}

TEST(ConeProgram, ProjectsOntoADisk) {
  // (2, x, y) ∈ Q³: the disk of radius 2.
  const Eigen::MatrixXd disk = rows({0, 0, 1, 0, 0, 1});
  const test::Solved solved = test::solveProgram(projection({3, 4}, {disk}, {{-2, 0, 0}}));
  EXPECT_EQ(solved.solution.status, SolveStatus::kOptimal);
  EXPECT_NEAR(solved.x[0], 1.2, 1e-5);
  EXPECT_NEAR(solved.x[1], 1.6, 1e-5);
  // The dual is the pull of the boundary: y = 3 (1, −x/2, −y/2).
  EXPECT_NEAR(solved.solution.y[0][0], 3.0, 1e-4);
  EXPECT_NEAR(solved.solution.y[0][1], -1.8, 1e-4);
}

TEST(ConeProgram, WithoutConstraintsIsOneLinearSolve) {
  const test::Solved solved = test::solveProgram(projection({3, 4}, {}, {}));
  EXPECT_EQ(solved.solution.status, SolveStatus::kOptimal);
  EXPECT_NEAR(solved.x[0], 3.0, 1e-12);
  EXPECT_NEAR(solved.x[1], 4.0, 1e-12);
}

TEST(ConeProgram, AMinimiserWithoutActiveConstraintsIsExact) {
  const Eigen::MatrixXd disk = rows({0, 0, 1, 0, 0, 1});
  const test::Solved inside = test::solveProgram(projection({1, 0.5}, {disk}, {{-2, 0, 0}}));
  EXPECT_EQ(inside.solution.status, SolveStatus::kOptimal);
  EXPECT_TRUE(inside.solution.isFree);
  EXPECT_EQ(inside.solution.iterations, 0);
  EXPECT_NEAR(inside.x[0], 1.0, 1e-15);
  EXPECT_NEAR(inside.x[1], 0.5, 1e-15);
  const test::Solved outside = test::solveProgram(projection({3, 4}, {disk}, {{-2, 0, 0}}));
  EXPECT_FALSE(outside.solution.isFree);
  EXPECT_GT(outside.solution.iterations, 0);
}

TEST(ConeProgram, ContradictionIsReportedInfeasible) {
  const Eigen::MatrixXd right = rows({1, 0, 0, 1, 0, 0}), left = rows({-1, 0, 0, 1, 0, 0});
  const test::Solved solved =
      test::solveProgram(projection({0.3, 0.1}, {right, left}, {{1, 0, 0}, {1, 0, 0}}));
  EXPECT_EQ(solved.solution.status, SolveStatus::kInfeasible)
      << socp::statusName(solved.solution.status);
  EXPECT_TRUE(solved.x.allFinite());
}

/// Whether y proves that no x has F x − h in the cones: y in them, Fᵀy = 0 and hᵀy > 0, to 8 digits.
bool isFarkas(const test::RandomProgram& p, const std::vector<Eigen::Vector3d>& y) {
  Eigen::VectorXd pull = Eigen::VectorXd::Zero(p.realC().size());
  double gain = 0.0, offset = 0.0;
  for (std::size_t b = 0; b < y.size(); ++b) {
    if (socp::depth(y[b]) < -1e-12 * y[b].norm()) return false;
    pull += p.fullF(b).transpose() * y[b];
    gain += p.h[b].dot(y[b]);
    offset = std::max(offset, p.h[b].norm());
  }
  return gain > 0.0 && offset * pull.norm() <= 1e-7 * gain;
}

TEST(ConeProgram, NoProgramIsCalledInfeasibleWithoutACertificate) {
  const auto check = [](const test::RandomProgram& p, int& proven, const std::string& name) {
    const test::Solved solved = test::solveProgram(p);
    const SolveStatus status = solved.solution.status;
    EXPECT_NE(status, SolveStatus::kOptimal) << name;
    if (status != SolveStatus::kInfeasible) return;
    ++proven;
    EXPECT_TRUE(isFarkas(p, solved.solution.y)) << name;
  };
  // Wedges that turn away from one another, the more narrowly the larger the angle between their axes.
  int proven = 0;
  for (int degrees = 100; degrees <= 180; degrees += 10) {
    const double a = degrees * 3.14159265358979 / 180.0;
    const Eigen::MatrixXd right = rows({1, 0, 0, 1, 0, 0}),
                          turned =
                              rows({std::cos(a), std::sin(a), -std::sin(a), std::cos(a), 0, 0});
    check(projection({0.3, 0.1}, {right, turned}, {{1, 0, 0}, {1, 0, 0}}), proven,
          "wedges at " + std::to_string(degrees));
  }
  EXPECT_EQ(proven, 9);
  // x ≥ √(x² + 1) has no solution, and no certificate either: x → ∞ comes as close as one wants. Nothing is claimed.
  proven = 0;
  const Eigen::MatrixXd asymptote = rows({1, 0, 1, 0, 0, 0});
  check(projection({0.3, 0.1}, {asymptote}, {{0, 0, -1}}), proven, "asymptote");
  EXPECT_EQ(proven, 0);
}

TEST(ConeProgram, OptimumFulfilsTheKktConditions) {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    const test::RandomProgram p = test::randomProgram(seed);
    const test::Solved solved = test::solveProgram(p);
    ASSERT_EQ(solved.solution.status, SolveStatus::kOptimal)
        << seed << " " << socp::statusName(solved.solution.status);
    Eigen::VectorXd stationarity = p.realH() * solved.x + p.realC();
    double gap = 0.0, size = 1.0;
    for (std::size_t b = 0; b < p.cliques.size(); ++b) {
      const Eigen::Vector3d s = p.fullF(b) * solved.x - p.h[b];
      const Eigen::Vector3d& y = solved.solution.y[b];
      EXPECT_GT(socp::depth(s), -1e-6) << seed;
      EXPECT_GT(socp::depth(y), -1e-9 * (1.0 + y.norm())) << seed;
      stationarity -= p.fullF(b).transpose() * y;
      gap += std::abs(s.dot(y));
      size += y.norm();
    }
    EXPECT_LT(stationarity.norm(), 1e-4 * size) << seed;
    EXPECT_LT(gap, 1e-4 * (1.0 + std::abs(p.realC().dot(solved.x)))) << seed;
    EXPECT_LE(solved.solution.iterations, 25) << seed;
  }
}

TEST(ConeProgram, ProgressIsReportedEveryIterationAndMayCancel) {
  const test::RandomProgram p = test::randomProgram(5);
  int calls = 0;
  socp::SolveOptions options;
  options.progress = [&](int iteration, double residual) {
    EXPECT_EQ(iteration, calls++);
    EXPECT_GE(residual, 0.0);
    return iteration < 2;
  };
  EXPECT_EQ(test::solveProgram(p, options).solution.status, SolveStatus::kCancelled);
  EXPECT_EQ(calls, 3);
}

TEST(ConeProgram, StopsAtItsIterationLimitWithTheBestPoint) {
  socp::SolveOptions options;
  options.maxIterations = 2;
  const test::Solved solved = test::solveProgram(test::randomProgram(7), options);
  EXPECT_TRUE(solved.solution.status == SolveStatus::kIterationLimit ||
              solved.solution.status == SolveStatus::kAlmost);
  EXPECT_TRUE(solved.x.allFinite());
}

TEST(ConeProgram, HandlesNumbersThatAreNotFinite) {
  test::RandomProgram p = test::randomProgram(9);
  p.h[0][0] = std::nan("");
  const test::Solved solved = test::solveProgram(p);
  EXPECT_NE(solved.solution.status, SolveStatus::kOptimal);
}

}  // namespace
}  // namespace hgp
