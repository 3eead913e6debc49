// Which of several uncertified maps is handed out.  Law: the one of the best round, not of the last.
#include <gtest/gtest.h>

#include <algorithm>

#include "hgp/parametrize/parametrize.h"
#include "support/prescriptions.h"
#include "support/shapes.h"

namespace hgp {
namespace {

int wrongIn(const Round& round) { return round.flipped + round.wrongAngles; }

TEST(BestAttempt, IsTheMapOfTheRoundWithTheFewestWrongTrianglesAndAngles) {
  // The program as printed, whose later rounds are often worse where cones are strong and close to one another.
  const TriMesh mesh = test::icosphere(6).mesh();
  const Topology topology = computeTopology(mesh);
  std::mt19937 random(17);
  int lastIsWorse = 0;
  for (int n = 0; n < 30; ++n) {
    const auto spec = test::randomSpec(mesh, topology, {4, 6 + n % 20}, random);
    if (!spec) continue;
    ParametrizeOptions options;
    options.method = Method::kPrinted;
    options.maxRounds = 6;
    const Result<Parametrization> run = parametrize(mesh, *spec, options);
    if (!run || run->isCertified || run->rounds.size() < 2) continue;
    int best = wrongIn(run->rounds[0]);
    for (const Round& round : run->rounds) best = std::min(best, wrongIn(round));
    const auto& facts = run->certificate;
    const int wrong = static_cast<int>(facts.orientation.notPositive.size());
    EXPECT_LE(wrong, best) << n;
    lastIsWorse += wrongIn(run->rounds.back()) > best;
  }
  EXPECT_GT(lastIsWorse, 0);
}

}  // namespace
}  // namespace hgp
