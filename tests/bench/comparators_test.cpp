#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/optimize/solved.h"
#include "cut_maps.h"
#include "hgp/field/mesh_trees.h"
#include "hgp/improve/improve.h"
#include "least_squares_conformal.h"
#include "slim.h"

namespace hgp::bench {
namespace {

/// A problem with a certified map and the terms of its unknowns, or of one unknown per copy.
struct Start {
  test::SeamlessProblem problem;
  Eigen::VectorXcd x;

  ReducedMap over(const ReducedUnknowns& unknowns) const {
    return {problem.surface.mesh, problem.surface.context.geometry, problem.surface.cut, unknowns};
  }
  DistortionFacts verified(const Eigen::VectorXcd& z) const {
    return problem.certify({z.data(), z.data() + z.size()}).distortion;
  }
};

std::vector<char> noneOf(const ReducedUnknowns& unknowns) {
  return std::vector<char>(static_cast<std::size_t>(unknowns.count), 0);
}

const std::vector<Start>& starts() {
  static const std::vector<Start> all = [] {
    std::vector<Start> found;
    for (test::CutSurface& surface : test::makeCutSurfaces(7)) {
      test::SeamlessProblem problem = test::problemOf(std::move(surface));
      const ProgramResult solved = problem.solve(problem.frames(), problem.weightedOptions());
      if (!solved.z.empty() && problem.certify(solved.z).isCertified)
        found.push_back({std::move(problem), solved.x});
    }
    return found;
  }();
  return all;
}

/// A jittered disk in the plane.
TriMesh flatDisk(int n) {
  test::Shape shape = test::jittered(test::disk(n), 0.2 / n);
  for (Vec3& p : shape.data.positions) p[2] = 0.0;
  return shape.mesh();
}

SlimOptions untilTheEnd() {
  SlimOptions options;
  options.relativeDecrease = 1e-7;
  options.maxSteps = 2000;
  return options;
}

SlimResult slimOf(const FaceTerms& terms, const Eigen::VectorXcd& x, const SlimOptions& options) {
  const Eigen::VectorXcd free = terms.free().gather(x);
  return slim(terms, free / dirichletScale(terms, free), options);
}

TEST(Slim, LowersTheEnergyInEveryStepAndKeepsSeamsThatAreHeld) {
  ASSERT_GT(starts().size(), 10u);
  for (const Start& start : starts()) {
    const ReducedUnknowns& unknowns = start.problem.unknowns;
    const FaceTerms terms(start.over(unknowns), noneOf(unknowns), start.x);
    const SlimResult run = slimOf(terms, start.x, {});
    for (std::size_t n = 1; n < run.energies.size(); ++n)
      EXPECT_LT(run.energies[n], run.energies[n - 1]) << start.problem.surface.name;
    EXPECT_GE(run.energies.back(), 4.0 - 1e-9);
    Eigen::VectorXcd x = start.x;
    terms.free().scatter(run.free, x);
    const Eigen::VectorXcd z = unknowns.copies * x;
    EXPECT_TRUE(start.problem.certify({z.data(), z.data() + z.size()}).isCertified);
    // The energy of its last step is the one that the verifier measures at the best scale, or above it.
    EXPECT_GE(run.energies.back() + 1e-9, 4.0 + start.verified(z).symmetricDirichlet);
  }
}

TEST(Slim, EndsWhereProjectedNewtonEndsOnTheSameUnknowns) {
  // Two descents that share neither Hessian nor line search; the minimum need not be the only one.
  int same = 0, tried = 0;
  for (const Start& start : starts()) {
    const ReducedUnknowns loose = freeUnknowns(start.problem.surface.cut);
    const Eigen::VectorXcd z = start.problem.unknowns.copies * start.x;
    for (const bool isFree : {false, true}) {
      const ReducedUnknowns& unknowns = isFree ? loose : start.problem.unknowns;
      const Eigen::VectorXcd& x = isFree ? z : start.x;
      const ReducedMap map = start.over(unknowns);
      const FaceTerms terms(map, noneOf(unknowns), x);
      ImproveOptions options;
      options.relativeDecrease = 1e-9;
      options.maxSteps = 300;
      const Improvement newton = improve(map, vertexTree(start.problem.surface.mesh), x, options);
      const double local = slimOf(terms, x, untilTheEnd()).energies.back();
      const double direct = 4.0 + 4.0 * newton.excessAfter;
      ++tried;
      same += std::fabs(local - direct) < 2e-3 * direct;
    }
  }
  EXPECT_GE(20 * same, 19 * tried) << same << " of " << tried;
}

TEST(Slim, WithoutSeamsHeldIsNoWorse) {
  for (const Start& start : starts()) {
    const ReducedUnknowns loose = freeUnknowns(start.problem.surface.cut);
    const Eigen::VectorXcd z = start.problem.unknowns.copies * start.x;
    const FaceTerms held(start.over(start.problem.unknowns), noneOf(start.problem.unknowns),
                         start.x);
    const FaceTerms free(start.over(loose), noneOf(loose), z);
    const double with = slimOf(held, start.x, untilTheEnd()).energies.back();
    const double without = slimOf(free, z, untilTheEnd()).energies.back();
    EXPECT_LE(without, 1.01 * with) << start.problem.surface.name;
  }
}

TEST(Slim, BringsAFlatMeshThatWasStretchedBackToItself) {
  const TriMesh mesh = flatDisk(6);
  const Geometry geometry = computeGeometry(mesh);
  const CutMesh cut =
      cutToDisk(mesh, PerEdge<char>(static_cast<std::size_t>(mesh.edgeCount()), 0), {});
  const ReducedUnknowns unknowns = freeUnknowns(cut);
  Eigen::VectorXcd z(unknowns.count);
  for (int c = 0; c < unknowns.count; ++c) {
    const Vec3& p = mesh.position(cut.parent[CutVertexId(c)]);
    z[c] = {3.0 * p[0] + 0.4 * p[1], 0.7 * p[1]};
  }
  const FaceTerms terms({mesh, geometry, cut, unknowns}, noneOf(unknowns), z);
  EXPECT_NEAR(slimOf(terms, z, untilTheEnd()).energies.back(), 4.0, 1e-5);
}

TEST(LeastSquaresConformal, ReproducesAFlatMeshFromTwoOfItsPoints) {
  const TriMesh mesh = flatDisk(8);
  const Geometry geometry = computeGeometry(mesh);
  const CutMesh cut =
      cutToDisk(mesh, PerEdge<char>(static_cast<std::size_t>(mesh.edgeCount()), 0), {});
  const ReducedUnknowns unknowns = freeUnknowns(cut);
  Eigen::VectorXcd flat(unknowns.count);
  for (int c = 0; c < unknowns.count; ++c) {
    const Vec3& p = mesh.position(cut.parent[CutVertexId(c)]);
    flat[c] = {p[0], p[1]};
  }
  const auto [a, b] = farApart(mesh, cut);
  ASSERT_NE(a, b);
  std::vector<char> isHeld = noneOf(unknowns);
  isHeld[static_cast<std::size_t>(a)] = isHeld[static_cast<std::size_t>(b)] = 1;
  Eigen::VectorXcd x = flat;
  for (int c = 0; c < unknowns.count; ++c)
    if (!isHeld[static_cast<std::size_t>(c)]) x[c] = 0.0;
  const FaceTerms terms({mesh, geometry, cut, unknowns}, isHeld, x);
  terms.free().scatter(leastSquaresConformal(terms), x);
  EXPECT_LT((x - flat).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(LeastSquaresConformal, HasTheLeastConformalEnergyOfAllMapsWithTheseTwoPoints) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (const Start& start : starts()) {
    const ReducedUnknowns loose = freeUnknowns(start.problem.surface.cut);
    const auto [a, b] = farApart(start.problem.surface.mesh, start.problem.surface.cut);
    std::vector<char> isHeld = noneOf(loose);
    isHeld[static_cast<std::size_t>(a)] = isHeld[static_cast<std::size_t>(b)] = 1;
    Eigen::VectorXcd x = Eigen::VectorXcd::Zero(loose.count);
    x[b] = 1.0;
    const FaceTerms terms(start.over(loose), isHeld, x);
    const auto energyOf = [&](const Eigen::VectorXcd& free) {
      FaceParts parts;
      evaluateParts(terms, free, false, parts);
      double sum = 0.0;
      for (int f = 0; f < terms.faceCount(); ++f)
        sum += terms.weight(f) * std::norm(parts.anti[static_cast<std::size_t>(f)]);
      return sum;
    };
    const Eigen::VectorXcd best = leastSquaresConformal(terms);
    ASSERT_EQ(best.size(), terms.freeCount());
    const double least = energyOf(best);
    for (int n = 0; n < 5; ++n) {
      Eigen::VectorXcd other = best;
      for (Complex& p : other) p += 1e-3 * Complex(normal(random), normal(random));
      EXPECT_GT(energyOf(other), least) << start.problem.surface.name;
    }
  }
}

TEST(CutMaps, UnknownsOfAMapAreThoseThatItCameFrom) {
  for (const Start& start : starts()) {
    const Eigen::VectorXcd z = start.problem.unknowns.copies * start.x;
    double gap = 1.0;
    const UvMap map = start.problem.map({z.data(), z.data() + z.size()});
    const Eigen::VectorXcd x = unknownsOf(start.problem.unknowns, map, gap);
    EXPECT_LT(gap, 1e-9 * (1.0 + z.cwiseAbs().maxCoeff())) << start.problem.surface.name;
    EXPECT_LT((x - start.x).cwiseAbs().maxCoeff(), 1e-8 * (1.0 + start.x.cwiseAbs().maxCoeff()));
  }
}

}  // namespace
}  // namespace hgp::bench
