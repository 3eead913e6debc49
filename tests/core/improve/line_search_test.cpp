#include <gtest/gtest.h>

#include <cmath>

#include "core/optimize/solved.h"
#include "hgp/improve/best_scale.h"
#include "support/random.h"

namespace hgp {
namespace {

FaceParts randomPositive(int count, std::mt19937& random) {
  const auto real = [&] { return test::randomReal(random); };
  FaceParts parts;
  for (int f = 0; f < count; ++f) {
    const Complex p(real(), real()), m(real(), real());
    parts.similar.push_back(p);
    parts.anti.push_back(m * (0.95 * std::abs(p) / std::max(std::abs(m), std::abs(p))));
  }
  return parts;
}

double leastArea(const FaceParts& parts, const FaceParts& change, double step) {
  double least = 1e300;
  for (std::size_t f = 0; f < parts.similar.size(); ++f)
    least = std::min(least, std::norm(parts.similar[f] + step * change.similar[f]) -
                                std::norm(parts.anti[f] + step * change.anti[f]));
  return least;
}

TEST(LineSearch, StepToDegeneracyIsWhereTheFirstTriangleLosesItsArea) {
  std::mt19937 random(3);
  const auto real = [&] { return test::randomReal(random); };
  int bounded = 0;
  for (int n = 0; n < 400; ++n) {
    const FaceParts parts = randomPositive(4, random);
    FaceParts change;
    for (int f = 0; f < 4; ++f) {
      change.similar.emplace_back(real(), real());
      change.anti.emplace_back(real(), real());
    }
    const double step = stepToDegeneracy(parts, change, 5.0);
    ASSERT_GT(step, 0.0);
    ASSERT_LE(step, 5.0);
    for (int k = 0; k < 200; ++k) EXPECT_GT(leastArea(parts, change, step * k / 200.0), 0.0);
    if (step < 5.0) {
      ++bounded;
      EXPECT_NEAR(leastArea(parts, change, step), 0.0, 1e-9);
      EXPECT_LT(leastArea(parts, change, step * 1.0001), 0.0);
    }
  }
  EXPECT_GT(bounded, 200);
}

TEST(LineSearch, GrowthHasNoBoundAndShrinkingEndsAtAPoint) {
  std::mt19937 random(5);
  const FaceParts parts = randomPositive(50, random);
  FaceParts change = parts;
  for (Complex& p : change.similar) p *= 0.3;
  for (Complex& m : change.anti) m *= 0.3;
  EXPECT_DOUBLE_EQ(stepToDegeneracy(parts, change, 2.0), 2.0);
  for (Complex& p : change.similar) p *= -5.0;  // and one that shrinks all to a point at 1/1.5
  for (Complex& m : change.anti) m *= -5.0;
  EXPECT_NEAR(stepToDegeneracy(parts, change, 2.0), 1.0 / 1.5, 1e-6);
}

TEST(BestScale, IsAMinimumOfTheMeanEnergyWhereverTheSearchStarts) {
  const test::SeamlessProblem problem = test::sphereProblem(3, 4, {3, 3, 3, 3, 3, 3, 3, 3});
  const ReducedMap map{problem.surface.mesh, problem.surface.context.geometry, problem.surface.cut,
                       problem.unknowns};
  const std::vector<char> none(static_cast<std::size_t>(problem.unknowns.count), 0);
  const FaceTerms terms(map, none, Eigen::VectorXcd::Zero(problem.unknowns.count));
  std::mt19937 random(9);
  FaceParts parts = randomPositive(terms.faceCount(), random);
  for (const EnergyExponents& e : {EnergyExponents{1.0, 1.0}, EnergyExponents{0.1, 1.0},
                                   EnergyExponents{1.0, 1e-3}, EnergyExponents{1.0, 0.5}}) {
    const double scale = bestScale(e, terms, parts, 1.0);
    EXPECT_NEAR(bestScale(e, terms, parts, 1e4 * scale), scale, 1e-4 * scale);
    EXPECT_NEAR(bestScale(e, terms, parts, 1e-4 * scale), scale, 1e-4 * scale);
    const double least = meanEnergy(e, terms, parts, scale);
    EXPECT_GT(meanEnergy(e, terms, parts, 1.01 * scale), least);
    EXPECT_GT(meanEnergy(e, terms, parts, 0.99 * scale), least);
  }
  // All triangles alike and all but no weight on areas: from far away the slope is nearly constant.
  FaceParts alike = parts;
  std::fill(alike.similar.begin(), alike.similar.end(), Complex(30.0));
  std::fill(alike.anti.begin(), alike.anti.end(), Complex(3.0));
  for (const double from : {1.0, 1e4})
    EXPECT_NEAR(bestScale(exponentsAt(-1.0), terms, alike, from), std::sqrt(891.0), 1e-3);
  const EnergyExponents bent{1.0, 0.5, 1e-2};
  const double scale = bestScale(bent, terms, parts, 1.0);
  const double least = meanEnergy(bent, terms, parts, scale);
  EXPECT_GT(meanEnergy(bent, terms, parts, 1.01 * scale), least);
  EXPECT_GT(meanEnergy(bent, terms, parts, 0.99 * scale), least);
}

}  // namespace
}  // namespace hgp
