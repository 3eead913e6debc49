// Strips of quads that are cut where edges have the same ends.  Laws: the result has no such edges, is closed and
// has the valences of the grid; only strips through such edges are cut, far fewer quads than cutting all cells gives.
#include "hgp/quads/cut_strips.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "hgp/grid/snap.h"
#include "hgp/mesh/vectors.h"
#include "hgp/parametrize/parametrize.h"
#include "hgp/quads/multiple_edges.h"
#include "hgp/quads/quad_shapes.h"
#include "hgp/quads/refill.h"
#include "support/maps.h"
#include "support/shapes.h"

namespace hgp {
namespace {

/// Valences of a closed quad mesh other than 4, and its Euler characteristic.
struct Net {
  std::map<int, int> irregular;
  int euler = 0;
};
Net netOf(const QuadMesh& mesh) {
  std::vector<int> valence(mesh.positions.size(), 0);
  std::map<std::array<int, 2>, int> directed;
  for (const auto& quad : mesh.quads)
    for (std::size_t k = 0; k < 4; ++k) {
      ++valence[at(quad[k])];
      ++directed[{quad[k], quad[(k + 1) % 4]}];
    }
  Net out;
  for (const int n : valence)
    if (n != 4) ++out.irregular[n];
  for (const auto& [ends, count] : directed) {
    EXPECT_EQ(count, 1) << ends[0] << " " << ends[1];
    EXPECT_TRUE(directed.contains({ends[1], ends[0]})) << ends[0] << " " << ends[1];
  }
  out.euler = static_cast<int>(mesh.positions.size() + mesh.quads.size() - directed.size() / 2);
  return out;
}

std::vector<VertexId> conesOf(const CompleteSpec& spec) {
  std::vector<VertexId> cones;
  for (const ConePoint& cone : spec.cones) cones.push_back(cone.vertex);
  return cones;
}

/// Σ (4 − valence), which Euler's characteristic determines.
int excess(const Net& net) {
  int sum = 0;
  for (const auto& [valence, count] : net.irregular) sum += (4 - valence) * count;
  return sum;
}

TEST(CutStrips, SeparatesLoopsAndPairsAroundHandlesOfOneAndTwoCells) {
  // A torus of 5 by n cells: a strip across the ring of n edges has five quads, and separates five pairs.
  const TriMesh mesh = test::torus(8, 5).mesh();
  for (const auto& [around, cuts] : {std::pair{3, 0}, {2, 1}, {1, 2}}) {
    UvMap map = test::flatTorusMap(8, 5);
    for (Vec2& p : map.uv) p[0] *= around / 8.0;
    const Result<CutQuads> cut = cutStrips(mesh, map, 4);
    ASSERT_TRUE(cut) << cut.error().message;
    EXPECT_EQ(cut->cuts, cuts) << around;
    EXPECT_EQ(cut->replaced, 0) << around;
    EXPECT_EQ(cut->added, 5 * cuts) << around;
    EXPECT_EQ(cut->quads.quads.size(), at(5 * (around + cuts)));
    EXPECT_EQ(countMultipleEdges(cut->quads).pairs, 0);
    const Net net = netOf(cut->quads);
    EXPECT_TRUE(net.irregular.empty());
    EXPECT_EQ(net.euler, 0);
  }
}

/// A torus of m by n quads without geometry; vertex (i, j) is n i + j.
QuadNet torusNet(int m, int n) {
  QuadNet net;
  const auto vertex = [&](int i, int j) { return (i % m) * n + j % n; };
  for (int v = 0; v < m * n; ++v) {
    net.mesh.positions.push_back({static_cast<double>(v / n), static_cast<double>(v % n), 0.0});
    net.mesh.normals.push_back({0, 0, 1});
    net.mesh.face.push_back(FaceId(0));
    net.mesh.coneVertex.push_back(-1);
    net.mesh.lines.push_back({0, 0});
    net.mesh.isOnFeature.push_back(0);
  }
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      net.mesh.quads.push_back(
          {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
      // Edges along i are 2 v, those along j are 2 v + 1.
      net.edge.push_back(
          {2 * vertex(i, j), 2 * vertex(i + 1, j) + 1, 2 * vertex(i, j + 1), 2 * vertex(i, j) + 1});
    }
  net.middle.assign(at(2 * m * n), Vec3{0.3, 0.4, 0.0});
  net.middleNormal.assign(at(2 * m * n), Vec3{0, 0, 1});
  net.middleFace.assign(at(2 * m * n), FaceId(0));
  net.isFeature.assign(at(2 * m * n), 0);
  return net;
}

TEST(Refill, SeparatesOnePairPerFillingAndKeepsThePlaceOfCones) {
  QuadNet net = torusNet(6, 2);  // six rings of two edges
  net.mesh.coneVertex[0] = 7;    // not regular in a real mesh; here only a place to keep
  const std::optional<Refilled> refilled = refill(net);
  ASSERT_TRUE(refilled);
  EXPECT_EQ(refilled->count, 6);
  EXPECT_EQ(refilled->quads.quads.size(), 12u + 6u);
  EXPECT_EQ(countMultipleEdges(refilled->quads).pairs, 0);
  const Net after = netOf(refilled->quads);
  EXPECT_EQ(after.euler, 0);
  EXPECT_EQ(excess(after), 0);
  int atCone = 0;
  for (const auto& quad : refilled->quads.quads)
    atCone += static_cast<int>(std::count(quad.begin(), quad.end(), 0));
  EXPECT_EQ(atCone, 4);
  EXPECT_FALSE(refill(torusNet(5, 1))) << "quads that meet themselves have no filling";
  net.isFeature.assign(net.middle.size(), 1);
  EXPECT_FALSE(refill(net)) << "edges along features stay";
  const std::optional<Refilled> none = refill(torusNet(4, 3));
  ASSERT_TRUE(none);
  EXPECT_EQ(none->count, 0);
}

TEST(CutStrips, OfCoarseGridsKeepsConesAndAddsFewerQuadsThanCuttingEveryCell) {
  int cured = 0;
  for (const test::Shape& shape : {test::pretzel(1, 3), test::pretzel(3, 2), test::torus(18, 7),
                                   test::torus(30, 4), test::pretzel(5, 2), test::pretzel(4, 1)}) {
    const TriMesh mesh = test::jittered(shape, 0.02).mesh();
    const Result<CompleteSpec> spec = suggestCones(mesh, {});
    ASSERT_TRUE(spec);
    for (const double perCone : {0.6, 1.0, 1.5, 2.0, 3.0}) {
      ParametrizeOptions options;
      options.grid.cells = perCone * std::max<double>(4, static_cast<double>(spec->cones.size()));
      options.grid.mode = GridMode::kQuad;
      const Result<Parametrization> run = parametrize(mesh, toSpec(*spec), options);
      ASSERT_TRUE(run) << shape.name;
      if (!run->grid->isAligned) continue;
      const std::optional<UvMap> map = snapAligned(mesh, run->map, 4, conesOf(*spec));
      ASSERT_TRUE(map) << shape.name;
      const Result<QuadMesh> plain = extractQuads(mesh, *map, 4);
      const Result<CutQuads> cut = cutStrips(mesh, *map, 4);
      ASSERT_TRUE(plain) << shape.name;
      ASSERT_TRUE(cut) << shape.name << " " << perCone << ": " << cut.error().message;
      const auto size = static_cast<int>(plain->quads.size());
      EXPECT_EQ(static_cast<int>(cut->quads.quads.size()), size + cut->added) << shape.name;
      const bool isNeeded = countMultipleEdges(*plain).pairs > 0;
      EXPECT_EQ(cut->cuts + cut->replaced > 0, isNeeded) << shape.name;
      if (!isNeeded) continue;
      ++cured;
      EXPECT_EQ(countMultipleEdges(cut->quads).pairs, 0);
      EXPECT_LT(cut->added, 15 * size) << "two halvings add as many";
      const Net net = netOf(cut->quads);
      std::map<int, int> asked;
      for (const ConePoint& cone : spec->cones) ++asked[cone.k];
      if (cut->replaced == 0) {
        EXPECT_EQ(net.irregular, asked) << shape.name;
      }
      EXPECT_EQ(excess(net), 4 * shape.eulerCharacteristic()) << shape.name;
      EXPECT_EQ(net.euler, shape.eulerCharacteristic());
    }
  }
  EXPECT_GE(cured, 3);
}

TEST(CutStrips, LeavesAGridWithABoundaryAsItIs) {
  const TriMesh mesh = test::grid(5, 4).mesh();
  UvMap map = test::planarMap(mesh);
  for (Vec2& p : map.uv) p = {p[0] + 0.3125, p[1] + 0.3125};
  const Result<CutQuads> cut = cutStrips(mesh, map, 4);
  ASSERT_TRUE(cut) << cut.error().message;
  EXPECT_EQ(cut->cuts, 0);
  EXPECT_EQ(cut->quads.quads.size(), 12u);
  EXPECT_GT(cut->quads.clipped, 0);
}

TEST(QuadShapes, ACornerThatIsTurnedOverOrFlatCounts) {
  QuadMesh mesh;
  mesh.positions = {{0, 0, 0},     {2, 0, 0}, {2, 2, 0}, {0, 2, 0},
                    {0.4, 0.4, 0}, {1, 1, 0}, {1, 0, 0}};
  mesh.quads = {{0, 1, 2, 3}};
  EXPECT_EQ(countFoldedInSpace(mesh), 0);
  mesh.quads = {{4, 1, 2, 3}};
  EXPECT_EQ(countFoldedInSpace(mesh), 0) << "convex";
  QuadMesh small = mesh;
  for (Vec3& p : small.positions) p = scaled(p, 0x1p-332);
  EXPECT_EQ(scaledJacobian(small, 0), scaledJacobian(mesh, 0)) << "whatever the unit of length";
  mesh.quads = {{5, 1, 2, 3}};
  EXPECT_EQ(countFoldedInSpace(mesh), 1) << "a corner of half a turn";
  mesh.quads = {{0, 1, 3, 2}};
  EXPECT_EQ(countFoldedInSpace(mesh), 1) << "edges that cross";
  mesh.quads = {{0, 1, 2, 1}};
  EXPECT_EQ(countFoldedInSpace(mesh), 0) << "counted as folded at its cone";
}

}  // namespace
}  // namespace hgp
