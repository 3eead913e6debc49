#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <numeric>

#include "hgp/api/session.h"
#include "support/shapes.h"

namespace hgp::api {
namespace {

Result<SurfaceFacts> factsOf(const MeshData& mesh, const LoadOptions& options = {}) {
  Session session;
  EXPECT_TRUE(session.loadArrays(mesh.positions, mesh.triangles, options));
  return session.facts();
}

TEST(Facts, AnglesSatisfyGaussBonnet) {
  const MeshData mesh = test::puncturedTorus(12, 9).data;
  const auto facts = factsOf(mesh);
  ASSERT_TRUE(facts);
  double curvature = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (facts->representative[v] < 0 || facts->valence[v] == 0) continue;
    curvature += (facts->isBoundary[v] != 0 ? 1 : 2) * std::numbers::pi - facts->angle[v];
  }
  EXPECT_NEAR(curvature, -2 * std::numbers::pi, 1e-9);  // χ = −1
  const auto sum = std::accumulate(facts->valence.begin(), facts->valence.end(), 0U);
  EXPECT_EQ(sum, 3 * mesh.triangles.size());
  EXPECT_EQ(facts->neighbours.size(), facts->neighbourStart.back());
  EXPECT_GT(std::count(facts->isBoundary.begin(), facts->isBoundary.end(), 1), 0);
}

TEST(Facts, AreGivenForMeshesThatCannotBeSolved) {
  EXPECT_EQ(Session().facts().error().code, ErrorCode::kUsage);
  // Three triangles on one edge, one of them without corners of its own, and a vertex that nobody names.
  const MeshData fan{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}, {5, 5, 5}},
                     {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {2, 2, 3}}};
  LoadOptions strict;
  strict.isStrict = true;
  const auto facts = factsOf(fan, strict);
  ASSERT_TRUE(facts);
  EXPECT_EQ(facts->valence, (std::vector<std::uint32_t>{3, 3, 1, 1, 1, 0}));
  EXPECT_EQ(facts->component, (std::vector<int>{0, 0, 0, 0, 0, -1}));
  EXPECT_EQ(facts->isBoundary, (std::vector<std::uint8_t>{1, 1, 1, 1, 1, 0}));
}

TEST(Facts, ACopyThatIsLeftOutHasNoComponent) {
  MeshData mesh = test::icosphere(1).data;
  mesh.triangles.push_back(mesh.triangles.front());
  const auto facts = factsOf(mesh);
  ASSERT_TRUE(facts);
  EXPECT_EQ(facts->triangleComponent.back(), -1);
  EXPECT_EQ(facts->triangleComponent.front(), 0);
  EXPECT_EQ(std::count(facts->isBoundary.begin(), facts->isBoundary.end(), 1), 0);
}

}  // namespace
}  // namespace hgp::api
