// Grids of which nobody gave the number of cells.  Law: other cones are tried only where no number will do with those of the run.
#include "hgp/api/session/automatic_cells.h"

#include <gtest/gtest.h>

namespace hgp::api {
namespace {

Model modelOf(std::size_t triangles, std::size_t components) {
  Model model;
  model.mesh.triangles.resize(triangles);
  model.components.resize(components);
  return model;
}

SolveOptions chosenIn(GridMode mode) {
  SolveOptions options;
  options.choosesCells = true;
  options.grid = {100.0, 0.0, mode};
  return options;
}

/// Certified, on 100 cells.
Result<Parametrization> onGrid(bool isAligned, double workingCells) {
  Parametrization run;
  run.isCertified = true;
  run.grid = GridReport{};
  run.grid->cells = 100.0;
  run.grid->isAligned = isAligned;
  run.grid->workingCells = workingCells;
  return run;
}

TEST(AutomaticCells, AnyNumberIsGoodThatWorksWithTheConesOfTheRun) {
  const Model one = modelOf(1000, 1);
  const SolveOptions tiles = chosenIn(GridMode::kTile), quads = chosenIn(GridMode::kQuad);
  EXPECT_TRUE(isAnyNumberGood(one, tiles, onGrid(true, 0.0)));
  EXPECT_TRUE(isAnyNumberGood(one, tiles, onGrid(false, 1600.0)));
  EXPECT_FALSE(isAnyNumberGood(one, tiles, onGrid(false, 1601.0))) << "too small to look the same";
  EXPECT_TRUE(isAnyNumberGood(one, quads, onGrid(false, 400.0)));
  EXPECT_FALSE(isAnyNumberGood(one, quads, onGrid(false, 401.0)));
  EXPECT_FALSE(isAnyNumberGood(one, tiles, onGrid(false, 0.0))) << "no number is known";
}

TEST(AutomaticCells, OtherConesAreTriedWhereTheNumberMatters) {
  const Model one = modelOf(1000, 1);
  const SolveOptions tiles = chosenIn(GridMode::kTile);
  SolveOptions asked = tiles;
  asked.choosesCells = false;
  EXPECT_FALSE(isAnyNumberGood(one, asked, onGrid(true, 0.0)));
  EXPECT_FALSE(isAnyNumberGood(modelOf(1000, 2), tiles, onGrid(true, 0.0))) << "one spacing";
  EXPECT_TRUE(isAnyNumberGood(modelOf(100'001, 1), tiles, onGrid(true, 0.0)));
  EXPECT_TRUE(isAnyNumberGood(modelOf(100'000, 1), tiles, onGrid(false, 200.0)));
  EXPECT_FALSE(isAnyNumberGood(modelOf(100'001, 1), tiles, onGrid(false, 200.0)))
      << "the run would not be made again with that number";
  Result<Parametrization> failed = onGrid(true, 0.0);
  failed->isCertified = false;
  EXPECT_FALSE(isAnyNumberGood(one, tiles, failed));
  EXPECT_FALSE(isAnyNumberGood(one, tiles, Failure{ErrorCode::kUnsupported, "solve", "", {}}));
}

}  // namespace
}  // namespace hgp::api
