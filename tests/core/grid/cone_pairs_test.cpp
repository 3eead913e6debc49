// Cones that are neighbours.  Laws: their regions meet in a triangulation of the surface, 2V − 4 triangles on a
// sphere, all counterclockwise; the way of a pair is its distance, whatever route it takes.
#include "hgp/grid/cone_pairs.h"

#include <gtest/gtest.h>

#include <set>

#include "hgp/grid/grid_system.h"
#include "hgp/parametrize/parametrize.h"
#include "support/shapes.h"

namespace hgp {
namespace {

TEST(NeighbouringCones, AreTheTriangulationOfASphere) {
  const TriMesh mesh = test::jittered(test::icosphere(12), 0.01).mesh();
  const Parametrization run = *parametrize(mesh, toSpec(*suggestCones(mesh, {})), {});
  ASSERT_TRUE(run.isCertified);
  std::vector<VertexId> cones;
  for (const ConePoint& cone : run.spec.cones) cones.push_back(cone.vertex);
  ASSERT_GE(cones.size(), 4u);
  const auto system = GridSystem::make(mesh, run.map, 4, cones, GridMode::kTile, nullptr);
  ASSERT_TRUE(system);
  const ConeNeighbours all = system->neighbours(1e300);
  EXPECT_EQ(all.triangles.size(), 2 * cones.size() - 4);
  std::set<std::pair<int, int>> sides, paired;
  for (const ConeTriangle& t : all.triangles) {
    EXPECT_EQ(t.ab.a, t.ac.a);
    EXPECT_GT(std::imag(std::conj(t.ab.distance) * t.ac.distance), 0.0);
    for (const ConePair* side : {&t.ab, &t.ac}) sides.insert(std::minmax({side->a.i, side->b.i}));
    sides.insert(std::minmax({t.ab.b.i, t.ac.b.i}));
  }
  for (const ConePair& pair : all.pairs) paired.insert(std::minmax({pair.a.i, pair.b.i}));
  EXPECT_EQ(sides, paired);
  EXPECT_TRUE(system->neighbours(1e-9).triangles.empty());
}

}  // namespace
}  // namespace hgp
