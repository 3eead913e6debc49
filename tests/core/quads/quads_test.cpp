// Quad meshes from aligned maps.  Laws: closed surfaces give pure quads, V − E + F = χ, F = the map's
// area, valence k at every cone and 4 elsewhere, each edge twice; boundaries lose only what they cut.
#include "hgp/quads/quads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "hgp/mesh/vectors.h"
#include "hgp/parametrize/parametrize.h"
#include "hgp/quads/corner_places.h"
#include "hgp/quads/multiple_edges.h"
#include "support/maps.h"

namespace hgp {
namespace {

double areaOf(const UvMap& map) {
  double area = 0;
  for (const auto& t : map.cornerUv) {
    const Vec2 &a = map.uv[at(t[0])], &b = map.uv[at(t[1])], &c = map.uv[at(t[2])];
    area += 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
  }
  return area;
}

struct Counted {
  int vertices = 0, edges = 0;
  bool isManifold = true;  ///< every directed edge once, every vertex a single fan
  std::vector<int> valence;
  std::set<std::pair<int, int>> open;  ///< edges with one quad
};

Counted count(const QuadMesh& mesh) {
  Counted out;
  std::set<std::pair<int, int>> directed;
  out.valence.assign(mesh.positions.size(), 0);
  for (const auto& quad : mesh.quads)
    for (std::size_t k = 0; k < 4; ++k) {
      const int a = quad[k], b = quad[(k + 1) % 4];
      out.isManifold = out.isManifold && a != b && directed.insert({a, b}).second;
      ++out.valence[at(a)];
    }
  for (const auto& [a, b] : directed) {
    const bool isPaired = directed.count({b, a}) > 0;
    out.edges += !isPaired || a < b;
    if (!isPaired) out.open.insert({a, b});
  }
  out.vertices = static_cast<int>(mesh.positions.size());
  return out;
}

void expectClosedQuads(const TriMesh& mesh, const UvMap& map, const std::vector<ConePoint>& cones,
                       int euler, const std::string& name) {
  const Result<QuadMesh> quads = extractQuads(mesh, map, 4);
  ASSERT_TRUE(quads) << name << ": " << quads.error().message;
  const Counted c = count(*quads);
  EXPECT_TRUE(c.isManifold) << name;
  EXPECT_TRUE(c.open.empty()) << name;
  EXPECT_EQ(quads->clipped, 0) << name;
  const int faces = static_cast<int>(quads->quads.size());
  EXPECT_EQ(c.vertices - c.edges + faces, euler) << name;
  EXPECT_NEAR(areaOf(map), faces, 1e-6 * faces) << name;
  std::map<int, int> asked;
  for (const ConePoint& cone : cones) asked[cone.vertex.i] = cone.k;
  std::size_t met = 0;
  for (int v = 0; v < c.vertices; ++v) {
    const int cone = quads->coneVertex[at(v)];
    met += cone >= 0;
    EXPECT_EQ(c.valence[at(v)], cone >= 0 ? asked[cone] : 4) << name << " vertex " << v;
  }
  EXPECT_EQ(met, asked.size()) << name;
}

TEST(Quads, OfAlignedClosedSurfacesArePureAndCloseUp) {
  for (const test::Shape& shape :
       {test::jittered(test::icosphere(7), 0.01), test::jittered(test::pretzel(2, 3), 0.02),
        test::jittered(test::pretzel(5, 2), 0.02), test::jittered(test::torus(18, 12), 0.01)}) {
    const TriMesh mesh = shape.mesh();
    Result<CompleteSpec> spec = suggestCones(mesh, {});
    ASSERT_TRUE(spec);
    ParametrizeOptions options;
    options.grid.cells = 60 * std::max<double>(4, static_cast<double>(spec->cones.size()));
    options.grid.mode = GridMode::kQuad;
    Result<Parametrization> run = parametrize(mesh, toSpec(*spec), options);
    ASSERT_TRUE(run && run->grid && run->grid->isAligned) << shape.name;
    expectClosedQuads(mesh, run->map, run->spec.cones, shape.eulerCharacteristic(), shape.name);
  }
}

/// The corners where a surface of unit cubes is not flat.
std::vector<ConePoint> cubeCones(const TriMesh& mesh) {
  std::vector<ConePoint> cones;
  for (VertexId v : mesh.vertices()) {
    double angle = 0;
    for (HalfedgeId h : outgoingHalfedges(mesh, v)) {
      const Vec3 &p = mesh.position(v), &a = mesh.position(mesh.head(h)),
                 &b = mesh.position(mesh.tail(TriMesh::previous(h)));
      double dot = 0, x = 0, y = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        dot += (a[k] - p[k]) * (b[k] - p[k]);
        x += (a[k] - p[k]) * (a[k] - p[k]);
        y += (b[k] - p[k]) * (b[k] - p[k]);
      }
      angle += std::acos(dot / std::sqrt(x * y));
    }
    const int k = static_cast<int>(std::lround(angle * 2 / std::numbers::pi));
    if (k != 4) cones.push_back({v, k});
  }
  return cones;
}

TEST(Quads, GridLinesAlongMeshEdgesAndConesThatAreNeighbours) {
  // Unit cubes: every grid line runs along mesh edges, and cones are mesh neighbours.
  for (int genus : {0, 1, 3}) {
    const test::Shape shape = test::pretzel(genus);
    const TriMesh mesh = shape.mesh();
    expectClosedQuads(mesh, test::developedMap(mesh), cubeCones(mesh), shape.eulerCharacteristic(),
                      shape.name);
  }
}

TEST(Quads, FinerGridsOnTheSameTrianglesAndHalfCells) {
  const test::Shape shape = test::pretzel(1, 2);
  const TriMesh mesh = shape.mesh();
  // Triangles of half a cell: most vertices lie between grid points, on grid lines.
  UvMap map = test::developedMap(mesh);
  const double largest = areaOf(map);
  for (double factor : {1.0, 3.0, 7.0}) {
    UvMap scaled = map;
    for (Vec2& p : scaled.uv) p = {factor * p[0], factor * p[1]};
    const Result<QuadMesh> quads = extractQuads(mesh, scaled, 4);
    ASSERT_TRUE(quads) << quads.error().message;
    EXPECT_NEAR(static_cast<double>(quads->quads.size()), factor * factor * largest, 1e-9);
  }
}

TEST(MultipleEdges, AroundHandlesOfOneOrTwoCellsAreGoneAfterHalvings) {
  const TriMesh mesh = test::torus(8, 5).mesh();
  for (const auto& [around, halvings] : {std::pair{3, 0}, {2, 1}, {1, 2}}) {
    UvMap map = test::flatTorusMap(8, 5);
    for (Vec2& p : map.uv) p[0] *= around / 8.0;
    for (int h = 0; h <= kMaxHalvings; ++h) {
      const Result<QuadMesh> quads = extractQuads(mesh, map, 4, h);
      ASSERT_TRUE(quads) << quads.error().message;
      EXPECT_EQ(quads->quads.size(), at(5 * around) << (2 * h));
      const MultipleEdges found = countMultipleEdges(*quads);
      // Every ring has a loop, or two edges with the same ends; the quads of a loop have theirs, too.
      EXPECT_EQ(found.pairs > 0, h < halvings) << around << " around, halved " << h;
      EXPECT_EQ(found.foldedQuads, 0);
      EXPECT_EQ(count(*quads).isManifold, h >= halvings);
    }
  }
}

TEST(MultipleEdges, QuadsThatAreAloneAtAVertexAreFolded) {
  QuadMesh sphere;  // a cone of k = 1 at 0 and at 3; two edges join 1 and 2
  sphere.positions.resize(4);
  sphere.quads = {{0, 1, 2, 1}, {3, 2, 1, 2}};
  MultipleEdges found = countMultipleEdges(sphere);
  EXPECT_EQ(found.foldedQuads, 2);
  EXPECT_EQ(found.pairs, 0);
  // The corner of a sheet is alone in its quad, too.
  QuadMesh sheet;
  sheet.positions.resize(6);
  sheet.quads = {{0, 1, 4, 3}, {1, 2, 5, 4}};
  found = countMultipleEdges(sheet);
  EXPECT_EQ(found.foldedQuads + found.pairs, 0);
}

TEST(Quads, BoundaryCellsAreLeftOutAndCounted) {
  // A square of 5 × 4 cells, moved by a third of a cell: 4 × 3 whole cells remain.
  const TriMesh mesh = test::grid(5, 4).mesh();
  UvMap map = test::planarMap(mesh);
  const Result<QuadMesh> whole = extractQuads(mesh, map, 4);
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->quads.size(), 20u);
  for (Vec2& p : map.uv) p = {p[0] + 0.3125, p[1] + 0.3125};
  const Result<QuadMesh> cut = extractQuads(mesh, map, 4);
  ASSERT_TRUE(cut);
  EXPECT_EQ(cut->quads.size(), 12u);
  EXPECT_GT(cut->clipped, 0);
  EXPECT_EQ(count(*cut).vertices, 20);
}

TEST(Quads, CellsAroundAWholeRimAreLeftOutAndThoseAroundAConeRefused) {
  // Two cells along each side of a cube, its corners in the middle of cells, which have three edges there. The sides
  // lie on one another.
  const test::Shape cube = test::cube(8);
  const auto inCells = [](const TriMesh& mesh) {
    std::vector<Vec2> corners;
    for (FaceId f : mesh.faces()) {
      const auto [a, b, c] = mesh.corners(f);
      const Vec3 &p = mesh.position(a), &q = mesh.position(b), &r = mesh.position(c);
      std::size_t n = 0;
      while (p[n] != q[n] || p[n] != r[n]) ++n;
      std::size_t x = (n + 1) % 3, y = (n + 2) % 3;
      if (p[n] < 0.5) std::swap(x, y);
      for (const Vec3* each : {&p, &q, &r})
        corners.push_back({2 * (*each)[x] + 0.5, 2 * (*each)[y] + 0.5});
    }
    return test::mapOfCorners(mesh, corners);
  };
  const TriMesh closed = cube.mesh();
  const Result<QuadMesh> refused = extractQuads(closed, inCells(closed), 4);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("cone"), std::string::npos) << refused.error().message;

  // Without a triangle at each corner there are rims instead, which turn as the cones did.
  const auto isEnd = [](double x) { return std::abs(x) < 1e-9 || std::abs(x - 1) < 1e-9; };
  std::set<int> corners;
  std::vector<int> faces;
  for (std::size_t f = 0; f < cube.data.triangles.size(); ++f)
    for (int v : cube.data.triangles[f]) {
      const Vec3& p = cube.data.positions[at(v)];
      if (isEnd(p[0]) && isEnd(p[1]) && isEnd(p[2]) && corners.insert(v).second)
        faces.push_back(static_cast<int>(f));
    }
  ASSERT_EQ(faces.size(), 8u);
  const TriMesh open = test::withoutFaces(cube, faces).mesh();
  const Result<QuadMesh> quads = extractQuads(open, inCells(open), 4);
  ASSERT_TRUE(quads) << quads.error().message;
  EXPECT_EQ(quads->quads.size(), 18u);
  EXPECT_EQ(quads->clipped, 8);
  EXPECT_EQ(count(*quads).open.size(), 24u);
}

TEST(Quads, CellsWithTwoEdgesAreLeftOut) {
  // Two squares, one behind the other, joined along their sides: half a turn at each corner, in the middle of a cell.
  constexpr int kSide = 8;
  test::Shape shape{"pillow", {}, 0, 0};
  MeshData& data = shape.data;
  std::map<std::array<int, 3>, int> names;
  const auto vertex = [&](int x, int y, int side) {
    const bool isRim = x == 0 || y == 0 || x == kSide || y == kSide;
    const int z = isRim ? 0 : side;
    const auto [it, isNew] = names.try_emplace({x, y, z}, static_cast<int>(names.size()));
    if (isNew) data.positions.push_back({x / 8.0, y / 8.0, z / 8.0});
    return it->second;
  };
  std::vector<Vec2> uv;
  std::set<int> corners;  // without a triangle each
  const auto add = [&](std::array<std::array<int, 2>, 3> at, int side) {
    if (side < 0) std::swap(at[1], at[2]);
    std::array<int, 3> triangle{};
    bool isFirst = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [x, y] = at[k];
      triangle[k] = vertex(x, y, side);
      const bool isCorner = x % kSide == 0 && y % kSide == 0;
      isFirst = isFirst || (isCorner && corners.insert(triangle[k]).second);
    }
    if (isFirst) return;
    data.triangles.push_back(triangle);
    for (const auto& [x, y] : at)
      uv.push_back(side > 0 ? Vec2{x / 4.0 + 0.5, y / 4.0 + 0.5}
                            : Vec2{y / 4.0 + 0.5, x / 4.0 + 0.5});
  };
  for (int side : {1, -1})
    for (int x = 0; x < kSide; ++x)
      for (int y = 0; y < kSide; ++y) {
        // No diagonal joins two sides, which both squares would have.
        const bool isFalling = x + y == kSide - 1;
        add({{{x, y}, {x + 1, y}, {isFalling ? x : x + 1, y + 1}}}, side);
        add({{{isFalling ? x + 1 : x, y}, {x + 1, y + 1}, {x, y + 1}}}, side);
      }
  ASSERT_EQ(corners.size(), 4u);
  const TriMesh mesh = test::meshOf(data);
  const Result<QuadMesh> quads = extractQuads(mesh, test::mapOfCorners(mesh, uv), 4);
  ASSERT_TRUE(quads) << quads.error().message;
  EXPECT_EQ(quads->quads.size(), 6u);
  EXPECT_EQ(quads->clipped, 4);
}

TEST(Quads, MoreThanMemoryHoldsAreRefused) {
  const TriMesh mesh = test::torus(6, 5).mesh();
  UvMap map = test::flatTorusMap(6, 5);
  for (Vec2& p : map.uv) p = {1024 * p[0], 1024 * p[1]};
  const Result<QuadMesh> quads = extractQuads(mesh, map, 4);
  ASSERT_FALSE(quads);
  EXPECT_EQ(quads.error().code, ErrorCode::kLimit);
  EXPECT_NE(quads.error().message.find("31457280"), std::string::npos) << quads.error().message;
  // Before the cells of a map are cut, too.
  EXPECT_FALSE(extractQuads(mesh, test::flatTorusMap(6, 5), 4, 10));
}

TEST(Quads, MapsThatAreNotAlignedAreRefused) {
  const TriMesh mesh = test::torus(6, 5).mesh();
  UvMap map = test::flatTorusMap(6, 5);
  EXPECT_TRUE(extractQuads(mesh, map, 4));
  EXPECT_FALSE(extractQuads(mesh, map, 3));
  for (Vec2& p : map.uv) p[0] *= 1.0 / 3;
  EXPECT_TRUE(extractQuads(mesh, test::flatTorusMap(6, 5), 2));
  const Result<QuadMesh> thirds = extractQuads(mesh, map, 4);
  EXPECT_FALSE(thirds && thirds->quads.size() * 3 != 30u);
  for (Vec2& p : map.uv) p[1] *= 0.3;
  EXPECT_FALSE(extractQuads(mesh, map, 4));
}

TEST(Quads, NormalsHaveLengthOne) {
  const TriMesh mesh = test::pretzel(1).mesh();
  const Result<QuadMesh> quads = extractQuads(mesh, test::developedMap(mesh), 4);
  ASSERT_TRUE(quads);
  ASSERT_EQ(quads->normals.size(), quads->positions.size());
  for (const Vec3& n : quads->normals) EXPECT_NEAR(std::hypot(n[0], n[1], n[2]), 1.0, 1e-12);
}

TEST(Quads, CornersLieInFacesOnTheSideOfTheirQuad) {
  const TriMesh mesh = test::pretzel(1).mesh();
  const Result<QuadMesh> quads = extractQuads(mesh, test::developedMap(mesh), 4);
  ASSERT_TRUE(quads);
  const QuadPlaces places = cornerPlaces(mesh, *quads);
  ASSERT_EQ(places.size(), quads->quads.size());
  for (std::size_t n = 0; n < places.size(); ++n) {
    Vec3 centre{};
    for (const int v : quads->quads[n]) centre = add(centre, scaled(quads->positions[at(v)], 0.25));
    for (std::size_t k = 0; k < 4; ++k) {
      const Vec3& p = quads->positions[at(quads->quads[n][k])];
      Vec3 there{}, middle{};
      double sum = 0;
      for (int c = 0; c < 3; ++c) {
        const Vec3& x = mesh.position(mesh.tail(TriMesh::halfedge(places[n][k].face, c)));
        const double w = places[n][k].weight[at(c)];
        EXPECT_GE(w, 0.0);
        sum += w;
        there = add(there, scaled(x, w));
        middle = add(middle, scaled(x, 1.0 / 3));
      }
      EXPECT_NEAR(sum, 1.0, 1e-14);
      EXPECT_LT(distance(there, p), 1e-12);
      // The quads of this map are squares of the surface, and its faces are their halves.
      EXPECT_LT(distance(middle, centre), distance(p, centre));
    }
  }
}

TEST(Quads, SidesCrossDiagonalsAndNoSides) {
  const TriMesh mesh = test::pretzel(1).mesh();
  const Result<QuadMesh> quads = extractQuads(mesh, test::developedMap(mesh), 4);
  ASSERT_TRUE(quads);
  const QuadPlaces places = cornerPlaces(mesh, *quads);
  const auto lengthOf = [&](EdgeId e) {
    const HalfedgeId h = mesh.halfedge(e);
    return distance(mesh.position(mesh.tail(h)), mesh.position(mesh.head(h)));
  };
  PerEdge<char> sides(at(mesh.edgeCount()), 0), diagonals(at(mesh.edgeCount()), 0);
  for (EdgeId e : mesh.edges()) (lengthOf(e) < 1.2 ? sides : diagonals)[e] = 1;
  const std::vector<char> overSides = crossesSeams(mesh, *quads, places, sides);
  EXPECT_EQ(std::count(overSides.begin(), overSides.end(), 1), 0);
  const std::vector<char> overDiagonals = crossesSeams(mesh, *quads, places, diagonals);
  // Where a diagonal meets no other, a way leads around its end.
  EXPECT_LE(std::count(overDiagonals.begin(), overDiagonals.end(), 0), 2);
}

}  // namespace
}  // namespace hgp
