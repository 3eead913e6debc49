// A certified map with automatic cones, its unknowns, and the cut on which one of its cones may move.
#pragma once

#include <gtest/gtest.h>

#include <optional>

#include "hgp/parametrize/live/read_map.h"
#include "hgp/parametrize/parametrize.h"
#include "support/shapes.h"

namespace hgp::live::test_support {

struct SolvedMap {
  explicit SolvedMap(const test::Shape& shape) : mesh(shape.mesh()), surface(mesh) {
    const Result<CompleteSpec> cones = suggestCones(surface, {});
    EXPECT_TRUE(cones);
    const Result<Parametrization> run = parametrize(surface, toSpec(*cones), {});
    EXPECT_TRUE(run && run->isCertified);
    std::vector<StageTime> times;
    Result<SeamlessSetup> made = prepareSeamless(surface, toSpec(run->spec), {}, times);
    EXPECT_TRUE(made);
    setup = std::move(*made);
    map = run->map;
    x = readMap(mesh, setup, map).value();
    cut.emplace(mesh, setup.cut, setup.seams, setup.unknowns, setup.cones.front());
  }

  TriMesh mesh;
  PreparedSurface surface;
  SeamlessSetup setup;
  UvMap map;
  Eigen::VectorXcd x;
  std::optional<MovedCut> cut;
};

}  // namespace hgp::live::test_support
