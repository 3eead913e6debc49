#include <gtest/gtest.h>

#include <cmath>

#include "hgp/parametrize/after/solution.h"
#include "hgp/parametrize/parametrize.h"
#include "hgp/parametrize/strategy/attempt.h"
#include "support/notes.h"
#include "support/prescriptions.h"
#include "support/shapes.h"

namespace hgp {
namespace {

/// Automatic cones of order q.
Result<CompleteSpec> conesOfOrder(const TriMesh& mesh, int q) {
  SuggestOptions suggest;
  suggest.q = q;
  return suggestCones(mesh, suggest);
}

/// Improved at `balance` where one is given.
Result<Parametrization> solve(const TriMesh& mesh, const Result<CompleteSpec>& spec,
                              std::optional<double> balance, const Progress& progress = {}) {
  if (!spec) return spec.error();
  ParametrizeOptions options;
  options.progress = progress;
  if (balance) options.improve.emplace().balance = *balance;
  return parametrize(mesh, toSpec(*spec), options);
}

std::vector<test::Shape> shapes() {
  return {
      test::jittered(test::icosphere(5), 0.05), test::doubleTorus(3), test::torus(16, 10),
      test::jittered(test::disk(8), 0.2),       test::annulus(16, 4), test::puncturedTorus(14, 9)};
}

TEST(EvenOut, RaisesTheSmallestAreasAndKeepsWhatIsCertified) {
  // A tube rolled out as an annulus: e^19 between the lengths at its ends.
  const TriMesh mesh = test::cylinder(8, 24).mesh();
  HolonomySpec spec;
  spec.turning = {4, -4};
  PreparedSurface surface(mesh);
  std::vector<StageTime> times;
  Result<SeamlessSetup> prepared = prepareSeamless(surface, spec, {}, times);
  ASSERT_TRUE(prepared);
  const auto setup = std::make_shared<const SeamlessSetup>(std::move(*prepared));
  const ParametrizeOptions options;
  const Problem problem = problemOf(mesh, setup, options);
  Attempts attempts(problem, options);
  const std::shared_ptr<const Attempt> attempt = attempts.make(firstState(problem), 1);
  ASSERT_EQ(attempt->wrongCount, 0);
  const double before = attempt->certificate.distortion.areaSpan;
  EXPECT_LT(before, 1e-9);
  MappedSolution mapped{
      {setup, attempt->program.x, attempt->u, attempt->frames}, attempt->map, attempt->certificate};
  mapped.certificate.isCertified = false;  // as if its number type were a coarser one
  Parametrization result;
  result.spec = setup->field.spec;
  ASSERT_TRUE(evenOut(mesh, options, mapped, result));
  EXPECT_TRUE(mapped.certificate.isCertified);
  EXPECT_GT(mapped.certificate.distortion.areaSpan, 100.0 * before);
  EXPECT_TRUE(certify(mesh, result.spec, mapped.map).isCertified);
  EXPECT_EQ(test::codesOf(result.notes), test::Codes{"map-areas-lowered"});
}

TEST(Improvement, NeverLosesACertificateAndNeverRaisesTheSymmetricDirichletEnergy) {
  int runs = 0;
  double logRatios = 0.0;
  for (const test::Shape& shape : shapes()) {
    const TriMesh mesh = shape.mesh();
    for (const int q : {2, 3, 4, 6}) {
      const Result<CompleteSpec> spec = conesOfOrder(mesh, q);
      const Result<Parametrization> plain = solve(mesh, spec, std::nullopt);
      ASSERT_TRUE(plain) << shape.name;
      if (!plain->isCertified) continue;
      EXPECT_FALSE(plain->improvement.has_value());
      for (const double balance : {0.0, q < 4 ? -1.0 : 1.0}) {
        const Result<Parametrization> better = solve(mesh, spec, balance);
        ASSERT_TRUE(better) << shape.name;
        EXPECT_TRUE(better->isCertified) << shape.name << " q = " << q << " at " << balance;
        ASSERT_TRUE(better->improvement.has_value());
        const ImprovementFacts& facts = *better->improvement;
        EXPECT_EQ(facts.asked.balance, balance);
        EXPECT_DOUBLE_EQ(facts.before.symmetricDirichlet,
                         plain->certificate.distortion.symmetricDirichlet);
        EXPECT_DOUBLE_EQ(facts.after.symmetricDirichlet,
                         better->certificate.distortion.symmetricDirichlet);
        if (balance != 0.0) continue;
        EXPECT_LE(facts.after.symmetricDirichlet, facts.before.symmetricDirichlet) << shape.name;
        if (facts.before.symmetricDirichlet < 1e-9)
          continue;  // an isometry: nothing can be lowered
        ++runs;
        logRatios += std::log(facts.after.symmetricDirichlet / facts.before.symmetricDirichlet);
      }
    }
  }
  EXPECT_GT(runs, 20);
  EXPECT_LT(std::exp(logRatios / runs), 0.6);  // the geometric mean: two fifths lower
}

TEST(Improvement, IsNoLongerHarmonicWhereItIsKept) {
  const TriMesh mesh = test::jittered(test::icosphere(5), 0.1).mesh();
  HolonomySpec spec;
  for (VertexId v : test::spreadVertices(mesh, 4)) spec.cones.push_back({v, 2});
  ParametrizeOptions options;
  const Result<Parametrization> plain = parametrize(mesh, spec, options);
  options.improve.emplace().balance = -1.0;
  const Result<Parametrization> better = parametrize(mesh, spec, options);
  ASSERT_TRUE(plain && better && plain->isCertified && better->isCertified);
  ASSERT_TRUE(better->improvement && better->improvement->isKept);
  EXPECT_LT(better->certificate.distortion.meanMu, plain->certificate.distortion.meanMu);
  EXPECT_EQ(better->spec.cones.size(), plain->spec.cones.size());
}

TEST(Improvement, CanBeCancelledInEveryStep) {
  const TriMesh mesh = test::jittered(test::icosphere(5), 0.05).mesh();
  const Result<CompleteSpec> spec = conesOfOrder(mesh, 4);
  int steps = 0;
  const Result<Parametrization> all = solve(mesh, spec, 0.0, [&](const ProgressReport& r) {
    steps += r.stage == Stage::kImprove;
    return true;
  });
  ASSERT_TRUE(all && all->isCertified);
  ASSERT_GT(steps, 2);
  for (int stop = 1; stop <= steps; ++stop) {
    int seen = 0;
    const Result<Parametrization> run = solve(mesh, spec, 0.0, [&](const ProgressReport& r) {
      return r.stage != Stage::kImprove || ++seen < stop;
    });
    ASSERT_FALSE(run);
    EXPECT_EQ(run.error().code, ErrorCode::kCancelled);
  }
}

TEST(Improvement, IsRefusedWhereTheBoundaryMustStayConvex) {
  ParametrizeOptions options;
  options.improve.emplace();
  const Result<Parametrization> run = parametrizeConvex(test::disk(4).mesh(), options);
  ASSERT_FALSE(run);
  EXPECT_EQ(run.error().code, ErrorCode::kUsage);
}

}  // namespace
}  // namespace hgp
