// Improvements along features.  Laws: less distortion, features as straight as before, nothing left to gain where a descent ends.
#include <gtest/gtest.h>

#include <cmath>

#include "along.h"
#include "hgp/improve/improve.h"
#include "hgp/parametrize/after/real_pairs.h"
#include "hgp/parametrize/along/straight_run.h"
#include "support/creases.h"
#include "support/random.h"

namespace hgp {
namespace {

double numberAsked(double balance, const DistortionFacts& facts) {
  if (balance < 0.0) return facts.meanMu;
  return balance > 0.0 ? facts.rmsLogArea : facts.symmetricDirichlet;
}

TEST(AlongImprovement, LowersWhatItIsAskedForAndKeepsLines) {
  int kept = 0, halved = 0;
  for (const test::CreasedShape& shape : test::creasedShapes())
    for (const double balance : {-1.0, 0.0, 1.0}) {
      ParametrizeOptions options;
      options.improve.emplace().balance = balance;
      const Result<Parametrization> run = test::along(shape.mesh, shape.features, options);
      ASSERT_TRUE(run) << shape.name;
      EXPECT_TRUE(run->isCertified) << shape.name;
      test::expectOnLines(shape.name, shape.mesh, *run, false);
      ASSERT_TRUE(run->improvement) << shape.name;
      const double before = numberAsked(balance, run->improvement->before);
      const double after = numberAsked(balance, run->certificate.distortion);
      EXPECT_EQ(after, numberAsked(balance, run->improvement->after)) << shape.name;
      EXPECT_LE(after, before) << shape.name;
      kept += run->improvement->isKept;
      halved += run->improvement->isKept && after < 0.5 * before;
    }
  EXPECT_GT(kept, 15);
  EXPECT_GT(halved, 5);
}

TEST(AlongImprovement, OnAGridWhatIsOnIntegersStaysThere) {
  int kept = 0;
  for (const test::CreasedShape& shape : test::creasedShapes())
    for (const GridMode mode : {GridMode::kTile, GridMode::kQuad}) {
      ParametrizeOptions options;
      options.grid.cells = 900;
      options.grid.mode = mode;
      options.improve.emplace();
      const Result<Parametrization> run = test::along(shape.mesh, shape.features, options);
      ASSERT_TRUE(run) << shape.name;
      ASSERT_TRUE(run->grid && run->grid->isAligned) << shape.name;
      EXPECT_TRUE(run->isCertified) << shape.name;
      test::expectOnLines(shape.name, shape.mesh, *run, true);
      EXPECT_EQ(run->certificate.exactSeams.integer,
                static_cast<int>(run->certificate.seams.seams.size()))
          << shape.name;
      for (const ConePoint& cone : run->spec.cones)
        for (std::size_t c = 0; c < run->copyOf.size(); ++c)
          for (const double x : run->map.uv[c])
            EXPECT_TRUE(mode == GridMode::kTile || run->copyOf[c] != cone.vertex ||
                        x == std::nearbyint(x))
                << shape.name;
      ASSERT_TRUE(run->improvement && run->improvement->onGrid) << shape.name;
      const DescentFacts& onGrid = *run->improvement->onGrid;
      EXPECT_LE(onGrid.after.symmetricDirichlet, onGrid.before.symmetricDirichlet);
      kept += onGrid.isKept;
    }
  EXPECT_GT(kept, 8);
}

/// A certified map along features, in real unknowns.
struct Straight {
  StraightSetup setup;
  Eigen::VectorXcd x;
};

Straight straightOf(const test::CreasedShape& shape, PreparedSurface& surface) {
  std::vector<StageTime> times;
  std::vector<Round> rounds;
  Straight out{*prepareStraight(surface, shape.features, HolonomySpec{}, {}, times), {}};
  const ParametrizeOptions options;
  StraightRun run(shape.mesh, out.setup, options, rounds);
  const Eigen::VectorXd values = run.run()->program.x;
  out.x = Eigen::VectorXcd::Zero(out.setup.seamless.unknowns.count);
  setParts(values, out.setup.unknowns.variable, out.x);
  return out;
}

/// Mean symmetric Dirichlet energy at the best scale, of real unknowns, from the corners of triangles alone.
double energyOf(const TriMesh& mesh, const StraightSetup& setup, const Eigen::VectorXd& values) {
  const Eigen::VectorXd z = setup.unknowns.rows * values;
  double grown = 0.0, shrunk = 0.0, surface = 0.0;
  for (FaceId f : mesh.faces()) {
    const Geometry& geometry = setup.seamless.context->ownGeometry();
    const LinearParts parts = linearParts(geometry, f);
    Complex p = 0.0, m = 0.0;
    for (int k = 0; k < 3; ++k) {
      const int c = setup.seamless.cut.copy[TriMesh::halfedge(f, k)].i;
      p += parts.similarity[at(k)] * Complex(z[2 * c], z[2 * c + 1]);
      m += parts.antisimilarity[at(k)] * Complex(z[2 * c], z[2 * c + 1]);
    }
    const double large = std::abs(p) + std::abs(m), small = std::abs(p) - std::abs(m);
    grown += geometry.area[f] * (large * large + small * small);
    shrunk += geometry.area[f] * (1.0 / (large * large) + 1.0 / (small * small));
    surface += geometry.area[f];
  }
  return 0.5 * std::sqrt(grown * shrunk) / surface;
}

TEST(AlongImprovement, EndsWhereNoRealUnknownCanLowerTheEnergyFurther) {
  std::mt19937 random(7);
  for (const test::CreasedShape& shape : test::creasedShapes()) {
    PreparedSurface surface(shape.mesh);
    const Straight start = straightOf(shape, surface);
    const StraightSetup& setup = start.setup;
    const RealUnknowns& real = setup.unknowns;
    for (const bool areSomeHeld : {false, true}) {
      std::vector<char> isHeld(at(real.count), 0);
      for (std::size_t i = 0; areSomeHeld && i < isHeld.size(); i += 5) isHeld[i] = 1;
      const RealPairs pairs(shape.mesh, setup.seamless.cut, setup.seamless.unknowns, real, isHeld);
      ImproveOptions options;
      options.relativeDecrease = 1e-12;
      options.maxSteps = 200;
      const Improvement run = improve(
          {shape.mesh, setup.seamless.context->ownGeometry(), setup.seamless.cut, pairs.unknowns()},
          setup.seamless.context->tree, pairs.pairsOf(partsOf(start.x, setup.unknowns.variable)),
          options, pairs.isHeld());
      const Eigen::VectorXd before = partsOf(start.x, real.variable);
      const Eigen::VectorXd after = partsOf(run.x, pairs.parts());
      const double least = energyOf(shape.mesh, setup, after);
      EXPECT_NEAR(least - 1.0, run.excessAfter, 1e-9 * (1.0 + least)) << shape.name;
      const double size = after.norm() / std::sqrt(static_cast<double>(real.count));
      for (int n = 0; n < 20; ++n) {
        Eigen::VectorXd direction(real.count);
        for (int i = 0; i < real.count; ++i) {
          direction[i] = isHeld[at(i)] ? 0.0 : size * test::randomReal(random);
          EXPECT_TRUE(!isHeld[at(i)] || after[i] == before[i]) << shape.name;
        }
        const double h = 1e-6;
        const auto slopeAt = [&](const Eigen::VectorXd& values) {
          return (energyOf(shape.mesh, setup, values + h * direction) -
                  energyOf(shape.mesh, setup, values - h * direction)) /
                 (2.0 * h);
        };
        EXPECT_LT(std::fabs(slopeAt(after)), 1e-4 * (1e-2 + std::fabs(slopeAt(before))))
            << shape.name << " (" << outcomeName(run.outcome) << ")";
      }
    }
  }
}

TEST(AlongImprovement, PairsGiveThePlacesOfTheRealUnknowns) {
  for (const test::CreasedShape& shape : test::creasedShapes()) {
    PreparedSurface surface(shape.mesh);
    const Straight start = straightOf(shape, surface);
    const StraightSetup& setup = start.setup;
    std::vector<char> isHeld(at(setup.unknowns.count), 0);
    for (std::size_t i = 0; i < isHeld.size(); i += 3) isHeld[i] = 1;
    for (const auto& held : {std::vector<char>(), isHeld}) {
      const RealPairs pairs(shape.mesh, setup.seamless.cut, setup.seamless.unknowns, setup.unknowns,
                            held);
      const Eigen::VectorXd values = partsOf(start.x, setup.unknowns.variable);
      const Eigen::VectorXcd places = pairs.unknowns().copies * pairs.pairsOf(values);
      const Eigen::VectorXd parts = setup.unknowns.rows * values;
      ASSERT_EQ(2 * places.size(), parts.size());
      for (Eigen::Index c = 0; c < places.size(); ++c)
        EXPECT_LT(std::abs(places[c] - Complex(parts[2 * c], parts[2 * c + 1])),
                  1e-12 * (1.0 + parts.cwiseAbs().maxCoeff()));
    }
  }
}

TEST(AlongImprovement, IsCancelled) {
  const TriMesh mesh = test::jittered(test::cube(5), 0.02).mesh();
  for (const Stage stage : {Stage::kImprove, Stage::kAlign}) {
    ParametrizeOptions options;
    options.improve.emplace();
    options.grid.cells = 500;
    options.progress = [&](const ProgressReport& r) { return r.stage != stage; };
    const Result<Parametrization> run = test::along(mesh, test::creasesOf(mesh), options);
    ASSERT_FALSE(run);
    EXPECT_EQ(run.error().code, ErrorCode::kCancelled);
  }
}

}  // namespace
}  // namespace hgp
