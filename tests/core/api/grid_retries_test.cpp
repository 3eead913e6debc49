// Other cones for a grid.  Laws: the cones of coarser grids are tried in order and the first near result wins; what
// is advised was solved; small components get whole fractions of a cell.
#include "hgp/api/request/grid_retries.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hgp::api {
namespace {

/// A certified result; aligned with cells of this spacing, or not.
Parametrization result(std::optional<double> spacing, double advice = 0.0) {
  Parametrization run;
  run.isCertified = true;
  run.grid = GridReport{};
  run.grid->cells = 100.0;
  run.grid->isAligned = spacing.has_value();
  run.grid->spacing = spacing.value_or(0.0);
  run.grid->workingCells = advice;
  return run;
}

struct Calls {
  std::vector<double> cones, grids;  ///< spacings
};

/// Aligned with the grid's own spacing when cones are chosen for spacings of at least `least`.
SolveAutomatic alignedFrom(double least, Calls& calls) {
  return [&calls, least](const SolveOptions& cones, const GridOptions& grid) {
    calls.cones.push_back(cones.grid.spacing);
    calls.grids.push_back(grid.spacing);
    const bool isAligned = cones.grid.spacing >= least && cones.conesFor != ConesFor::kFew;
    return Result<Parametrization>(isAligned ? result(grid.spacing) : result({}, 400.0));
  };
}

TEST(GridRetries, TheConesOfTheLeastCoarserGridThatWorksAreUsed) {
  Calls calls;
  Result<Parametrization> run = result({});
  Notes notes;
  ASSERT_TRUE(
      withOtherCones(100, {}, {0.0, 1.0, GridMode::kQuad}, alignedFrom(1.9, calls), run, notes));
  EXPECT_TRUE(run->grid->isAligned);
  EXPECT_EQ(calls.cones, (std::vector<double>{1.5, 2.0}));
  EXPECT_EQ(calls.grids, (std::vector<double>{1.0, 1.0})) << "the grid stays as asked";
  EXPECT_EQ(notes, Notes{Note("grid-other-cones", {{"factor", 2.0}})});
}

TEST(GridRetries, AnAlignedResultFarFromTheNumberOfCellsIsReplacedByANearOneOnly) {
  for (const double least : {0.0, 100.0}) {
    Calls calls;
    Result<Parametrization> run = result(0.8);  // 56 % more cells
    Notes notes;
    ASSERT_TRUE(withOtherCones(100, {}, {0.0, 1.0, GridMode::kQuad}, alignedFrom(least, calls), run,
                               notes));
    EXPECT_TRUE(run->grid->isAligned);
    EXPECT_EQ(run->grid->spacing, least > 0.0 ? 0.8 : 1.0);
    EXPECT_EQ(notes.empty(), least > 0.0);
  }
  Calls calls;
  Result<Parametrization> run = result(0.97);  // 6 %
  Notes notes;
  ASSERT_TRUE(
      withOtherCones(100, {}, {0.0, 1.0, GridMode::kQuad}, alignedFrom(0.0, calls), run, notes));
  EXPECT_TRUE(calls.cones.empty());
}

TEST(GridRetries, AnAdvisedNumberOfCellsWasTriedAndNothingElseIsAdvised) {
  // Nothing works at a spacing of 1; with cells half as long (400 for 100 cells) it does, or never.
  for (const bool works : {true, false}) {
    const SolveAutomatic solve = [&](const SolveOptions&, const GridOptions& grid) {
      const bool isAligned = works && grid.spacing < 0.6;
      return Result<Parametrization>(isAligned ? result(grid.spacing) : result({}, 200.0));
    };
    Result<Parametrization> run = result({}, 200.0);
    Notes notes;
    ASSERT_TRUE(withOtherCones(100, {}, {0.0, 1.0, GridMode::kQuad}, solve, run, notes));
    EXPECT_FALSE(run->grid->isAligned);
    EXPECT_EQ(run->grid->workingCells, works ? 400.0 : 0.0) << "200 cells were tried first";
    EXPECT_FALSE(run->grid->needsTheseCones);
  }
}

TEST(GridRetries, OnLargeSurfacesTheAdviceBelongsToTheConesOfTheRun) {
  Calls calls;
  Result<Parametrization> run = result({}, 400.0);
  Notes notes;
  ASSERT_TRUE(
      withOtherCones(50'000, {}, {0.0, 1.0, GridMode::kQuad}, alignedFrom(1e9, calls), run, notes));
  EXPECT_EQ(run->grid->workingCells, 400.0);
  EXPECT_TRUE(run->grid->needsTheseCones);
  EXPECT_EQ(calls.cones.size(), 5u);
}

TEST(GridRetries, ACancelledRetryCancels) {
  const SolveAutomatic solve = [](const SolveOptions&, const GridOptions&) {
    return Result<Parametrization>(Failure{ErrorCode::kCancelled, "solve", "", {}});
  };
  Result<Parametrization> run = result({});
  Notes notes;
  const Status done = withOtherCones(100, {}, {0.0, 1.0, GridMode::kTile}, solve, run, notes);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, ErrorCode::kCancelled);
}

TEST(GridRetries, AComponentSmallerThanItsCellsGetsWholeFractions) {
  int halvings = -1;
  GridOptions grid = wholeFraction({0.0, 2.0, GridMode::kQuad}, 100.0, 0, halvings);
  EXPECT_EQ(grid.spacing, 2.0);
  EXPECT_EQ(halvings, 0);
  grid = wholeFraction({0.0, 2.0, GridMode::kQuad}, 1.0, 0, halvings);  // a quarter of a cell
  EXPECT_EQ(halvings, 3);
  EXPECT_EQ(grid.spacing, 0.25);
  EXPECT_GE(1.0 / (grid.spacing * grid.spacing), kMinCells);
  grid = wholeFraction({0.0, 2.0, GridMode::kQuad}, 1.0, 1, halvings);
  EXPECT_EQ(halvings, 4);
  // Spacings of which the square is no number.
  for (const double spacing : {1e160, 1e300}) {
    grid = wholeFraction({0.0, spacing, GridMode::kQuad}, 1.0, 0, halvings);
    EXPECT_LE(grid.spacing, 1.0) << spacing;
    EXPECT_GT(grid.spacing, 0.1) << spacing;
  }
}

}  // namespace
}  // namespace hgp::api
