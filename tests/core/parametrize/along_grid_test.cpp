// Maps along features on a grid.  Laws: every feature edge lies on a line of integers, in both modes; the quads cover the whole
// surface, and every chain of features is a chain of their edges, with its corners as vertices.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "along.h"
#include "hgp/base/portable_math.h"
#include "hgp/mesh/vectors.h"
#include "hgp/parametrize/along/along_features.h"
#include "hgp/parametrize/along/given_values.h"
#include "hgp/parametrize/along/straight_run.h"
#include "hgp/quads/quads.h"
#include "support/creases.h"

namespace hgp {
namespace {

Result<Parametrization> onGrid(const TriMesh& mesh, const std::vector<EdgeId>& features,
                               const GridOptions& grid) {
  ParametrizeOptions options;
  options.grid = grid;
  return test::along(mesh, features, options);
}

bool isWhole(double x) { return x == std::nearbyint(x); }

/// Feature edges in cells, and the corners and ends of features.
struct Lines {
  double length = 0.0, rims = 0.0;
  int edges = 0, vertices = 0;
  std::vector<VertexId> nodes;
};

Lines linesOf(const TriMesh& mesh, const Parametrization& run) {
  Lines out;
  PerVertex<int> degree(at(mesh.vertexCount()), 0);
  const auto uv = [&](HalfedgeId h) {
    return run.map.uv[at(run.map.cornerUv[at(h.i / 3)][at(h.i % 3)])];
  };
  for (EdgeId e : run.spec.features) {
    const HalfedgeId h = mesh.halfedge(e);
    const Vec2 a = uv(h), b = uv(TriMesh::next(h));
    const bool isU = a[0] == b[0];
    EXPECT_TRUE(isWhole(a[isU ? 0 : 1])) << "edge " << e.i;
    const double length = std::fabs(isU ? b[1] - a[1] : b[0] - a[0]);
    out.length += length;
    if (mesh.isBoundary(h)) out.rims += length;
    ++out.edges;
    for (VertexId v : {mesh.tail(h), mesh.head(h)}) out.vertices += degree[v]++ == 0;
  }
  for (VertexId v : mesh.vertices())
    if (degree[v] > 0 && degree[v] != 2) out.nodes.push_back(v);
  return out;
}

double apart(const Vec3& a, const Vec3& b) { return norm(subtract(a, b)); }

double distanceToEdge(const TriMesh& mesh, EdgeId e, const Vec3& p) {
  const HalfedgeId h = mesh.halfedge(e);
  const Vec3 a = mesh.position(mesh.tail(h)), d = subtract(mesh.position(mesh.head(h)), a);
  const double t = std::clamp(dot(subtract(p, a), d) / dot(d, d), 0.0, 1.0);
  return apart(p, {a[0] + t * d[0], a[1] + t * d[1], a[2] + t * d[2]});
}

/// Edges of quads that have a quad on one side only.
int openEdges(const QuadMesh& quads) {
  std::vector<std::pair<int, int>> sides;
  for (const auto& q : quads.quads)
    for (std::size_t k = 0; k < 4; ++k) sides.push_back({q[k], q[(k + 1) % 4]});
  std::sort(sides.begin(), sides.end());
  return static_cast<int>(std::count_if(sides.begin(), sides.end(), [&](const auto& s) {
    return !std::binary_search(sides.begin(), sides.end(), std::pair{s.second, s.first});
  }));
}

TEST(AlongGrid, FeaturesLieOnIntegersInBothModes) {
  for (const test::CreasedShape& shape : test::creasedShapes())
    for (const GridMode mode : {GridMode::kTile, GridMode::kQuad}) {
      const Result<Parametrization> run = onGrid(shape.mesh, shape.features, {900.0, 0.0, mode});
      ASSERT_TRUE(run) << shape.name;
      EXPECT_TRUE(run->isCertified) << shape.name;
      ASSERT_TRUE(run->grid && run->grid->isAligned) << shape.name;
      if (!run->certificate.seams.seams.empty()) {
        EXPECT_TRUE(run->certificate.exactSeams.integer) << shape.name;
      }
      linesOf(shape.mesh, *run);
    }
}

TEST(AlongGrid, QuadsCoverTheWholeSurfaceAndFollowEveryFeature) {
  for (const test::CreasedShape& shape : test::creasedShapes()) {
    const TriMesh& mesh = shape.mesh;
    const Result<Parametrization> run = onGrid(mesh, shape.features, {900.0, 0.0, GridMode::kQuad});
    ASSERT_TRUE(run && run->grid && run->grid->isAligned) << shape.name;
    const Result<QuadMesh> quads = extractQuads(mesh, run->map, 4);
    ASSERT_TRUE(quads) << shape.name << ": " << quads.error().message;
    const Lines lines = linesOf(mesh, *run);
    EXPECT_EQ(quads->clipped, 0) << shape.name;
    EXPECT_EQ(static_cast<double>(quads->quads.size()), std::nearbyint(run->grid->cells))
        << shape.name;
    EXPECT_NEAR(run->grid->cells, std::nearbyint(run->grid->cells), 1e-6) << shape.name;
    EXPECT_EQ(openEdges(*quads), std::lround(lines.rims)) << shape.name;
    // As many vertices of quads lie on features as unit steps do, but for the Euler characteristic of the lines.
    Vec3 low = mesh.position(VertexId(0)), high = low;
    for (VertexId v : mesh.vertices())
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], mesh.position(v)[k]);
        high[k] = std::max(high[k], mesh.position(v)[k]);
      }
    const double near = 1e-6 * apart(low, high);
    const auto isOnFeature = [&](const Vec3& p) {
      return std::any_of(run->spec.features.begin(), run->spec.features.end(),
                         [&](EdgeId e) { return distanceToEdge(mesh, e, p) <= near; });
    };
    const auto onFeatures =
        std::count_if(quads->positions.begin(), quads->positions.end(), isOnFeature);
    EXPECT_EQ(onFeatures, std::lround(lines.length) + lines.vertices - lines.edges) << shape.name;
    for (VertexId v : lines.nodes)
      EXPECT_TRUE(std::any_of(quads->positions.begin(), quads->positions.end(),
                              [&](const Vec3& p) { return apart(p, mesh.position(v)) <= near; }))
          << shape.name << " vertex " << v.i;
  }
}

TEST(AlongGrid, DanglingEndsAreGridPointsOfQuads) {
  const TriMesh mesh = test::icosphere(5).mesh();
  const HalfedgeId h(0);
  std::vector<EdgeId> features{mesh.edge(h), mesh.edge(TriMesh::next(h)),
                               mesh.edge(HalfedgeId(900))};
  std::sort(features.begin(), features.end());
  const Result<Parametrization> run = onGrid(mesh, features, {3000.0, 0.0, GridMode::kQuad});
  ASSERT_TRUE(run && run->grid && run->grid->isAligned);
  const Result<QuadMesh> quads = extractQuads(mesh, run->map, 4);
  ASSERT_TRUE(quads);
  for (VertexId v : linesOf(mesh, *run).nodes)
    EXPECT_TRUE(std::any_of(quads->positions.begin(), quads->positions.end(), [&](const Vec3& p) {
      return apart(p, mesh.position(v)) < 1e-6;
    })) << v.i;
}

TEST(AlongGrid, AFewCellsAreEnoughForACube) {
  const TriMesh mesh = test::cube(4).mesh();
  const Result<Parametrization> run =
      onGrid(mesh, test::creasesOf(mesh), {6.0, 0.0, GridMode::kQuad});
  ASSERT_TRUE(run && run->grid && run->grid->isAligned);
  const Result<QuadMesh> quads = extractQuads(mesh, run->map, 4);
  ASSERT_TRUE(quads);
  EXPECT_EQ(quads->quads.size(), 6u);
  EXPECT_EQ(quads->positions.size(), 8u);
}

TEST(AlongGrid, CanBeCancelled) {
  const TriMesh mesh = test::cube(4).mesh();
  PreparedSurface surface(mesh);
  HolonomySpec spec;
  spec.features = test::creasesOf(mesh);
  ParametrizeOptions options;
  options.grid.cells = 100.0;
  options.progress = [](const ProgressReport& r) { return r.stage != Stage::kAlign; };
  const Result<Parametrization> run = parametrizeAlongFeatures(surface, spec, options);
  ASSERT_FALSE(run);
  EXPECT_EQ(run.error().code, ErrorCode::kCancelled);
}

TEST(AlongGrid, TheChoiceOfIntegersHasABudget) {
  int exhausted = 0;
  for (const test::CreasedShape& shape : test::creasedShapes()) {
    HolonomySpec spec;
    spec.features = shape.features;
    ParametrizeOptions options;
    // Few cells, so that lines have to be kept apart.
    options.grid = {40.0, 0.0, GridMode::kQuad};
    const auto gridWith = [&](double share) {
      PreparedSurface surface(shape.mesh);
      ParametrizeOptions less = options;
      less.maxStepsPerFace *= share;
      const Result<Parametrization> run = parametrizeAlongFeatures(surface, spec, less);
      EXPECT_TRUE(run && run->isCertified) << "the map without a grid stays";
      return *run->grid;
    };
    const int integers = gridWith(1.0).integers;
    const double least = std::pow(integers, 3) / 6e10;  // an update of every integer
    const GridReport many = gridWith(3.9 * least);
    ASSERT_TRUE(many.reason) << shape.name;
    EXPECT_EQ(many.reason->code, "features-many-integers") << shape.name;
    // So much that it may begin, but perhaps not end.
    const GridReport begun = gridWith(4.1 * least);
    if (begun.isAligned) continue;
    EXPECT_NE(begun.reason->code, "features-many-integers") << shape.name;
    exhausted += begun.reason->code == "features-grid-work" ? 1 : 0;
  }
  EXPECT_GT(exhausted, 0);
}

TEST(AlongGrid, WhereFramesLeaveNoMapOneWithoutThemShowsOthers) {
  int misled = 0;
  for (const test::CreasedShape& shape : test::creasedShapes()) {
    PreparedSurface surface(shape.mesh);
    std::vector<StageTime> times;
    const ParametrizeOptions options;
    const Result<StraightSetup> setup =
        prepareStraight(surface, shape.features, HolonomySpec{}, options, times);
    ASSERT_TRUE(setup) << shape.name;
    if (setup->base.empty()) continue;
    std::vector<Round> rounds;
    const auto solved = StraightRun(shape.mesh, *setup, options, rounds).run();
    ASSERT_TRUE(solved && solved->certificate.isCertified) << shape.name;
    const SeamlessSetup& seamless = setup->seamless;
    GridValues values{
        1.0, {}, framesOfMap(seamless.context->geometry, seamless.cut, solved->program.z)};
    rounds.clear();
    const auto again = StraightRun(shape.mesh, *setup, options, rounds, &values).run();
    EXPECT_TRUE(again && again->certificate.isCertified) << shape.name;
    EXPECT_EQ(rounds.size(), 1u) << shape.name;
    for (double& angle : values.angle.raw())
      angle += 2.0;  // no triangle can keep within a quarter turn of these
    rounds.clear();
    const auto other = StraightRun(shape.mesh, *setup, options, rounds, &values).run();
    EXPECT_TRUE(other && other->certificate.isCertified) << shape.name;
    misled += rounds.size() > 1 ? 1 : 0;  // a disk turns as a whole
  }
  EXPECT_GT(misled, 2);
}

TEST(AlongGrid, TrianglesThatGivenValuesReverseAreKnownBeforeAProgram) {
  for (const test::CreasedShape& shape : test::creasedShapes()) {
    PreparedSurface surface(shape.mesh);
    std::vector<StageTime> times;
    const ParametrizeOptions options;
    const auto setup = prepareStraight(surface, shape.features, HolonomySpec{}, options, times);
    ASSERT_TRUE(setup) << shape.name;
    std::vector<Round> rounds;
    const auto solved = StraightRun(shape.mesh, *setup, options, rounds).run();
    ASSERT_TRUE(solved && solved->certificate.isCertified) << shape.name;
    Eigen::VectorXd x = solved->program.x;
    GivenValues given;
    const auto reversed = [&] {
      given.clear();
      for (int i = 0; i < setup->unknowns.count; ++i) given.push_back({i, x[i]});
      return reversedByGiven(shape.mesh, *setup, given);
    };
    EXPECT_TRUE(reversed().empty()) << shape.name;
    // One value that is far off.
    x[x.size() / 2] += 1e3;
    const std::vector<Complex> z = placesOf(setup->unknowns, x);
    std::vector<FaceId> turned;
    for (FaceId f : shape.mesh.faces()) {
      const auto corner = [&](int k) {
        return z[at(setup->seamless.cut.copy[TriMesh::halfedge(f, k)].i)];
      };
      const Complex a = corner(0), b = corner(1) - a, c = corner(2) - a;
      if (!(b.real() * c.imag() > b.imag() * c.real())) turned.push_back(f);
    }
    EXPECT_FALSE(turned.empty()) << shape.name;
    EXPECT_EQ(reversed(), turned) << shape.name;
    // Of a vertex with a coordinate that is not given nothing is known.
    x.setZero();
    EXPECT_EQ(reversed().size(), at(shape.mesh.faceCount())) << "no area is not positive";
    for (VertexId v : shape.mesh.vertices()) {
      const int unknown = setup->seamless.unknowns.vertexUnknown[v];
      if (unknown < 0 || shape.mesh.isBoundary(v) || setup->aligned.sectors.isOnFeature[v])
        continue;
      std::erase_if(given, [&](const auto& pair) {
        return setup->unknowns.variable[at(pair.first)] == 2 * unknown + 1;
      });
      const std::vector<FaceId> left = reversedByGiven(shape.mesh, *setup, given);
      for (HalfedgeId h : outgoingHalfedges(shape.mesh, v))
        EXPECT_FALSE(std::binary_search(left.begin(), left.end(), TriMesh::face(h)));
      EXPECT_FALSE(left.empty()) << shape.name;
      break;
    }
  }
}

TEST(AlongGrid, FramesOfAMapTurnBackWithIt) {
  const test::CreasedShape shape = test::creasedShapes().front();
  PreparedSurface surface(shape.mesh);
  std::vector<StageTime> times;
  const auto setup = prepareStraight(surface, shape.features, HolonomySpec{}, {}, times);
  ASSERT_TRUE(setup);
  const SeamlessSetup& seamless = setup->seamless;
  std::vector<Round> rounds;
  const ParametrizeOptions options;
  std::vector<Complex> z =
      StraightRun(shape.mesh, *setup, options, rounds).solveWithoutFrames().program.z;
  const PerFace<double> before = framesOfMap(seamless.context->geometry, seamless.cut, z);
  constexpr double kTurn = 0.3;
  for (Complex& p : z) p *= portable::polar(2.0, kTurn);
  const PerFace<double> after = framesOfMap(seamless.context->geometry, seamless.cut, z);
  for (FaceId f : shape.mesh.faces()) {
    const Complex turn = portable::polar(1.0, before[f] - after[f]);
    EXPECT_NEAR(portable::arg(turn), kTurn, 1e-12);
  }
}

}  // namespace
}  // namespace hgp
