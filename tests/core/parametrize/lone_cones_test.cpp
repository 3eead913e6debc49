// Distances of a cone that is alone between features from the sides of its patch.  Laws: such a patch consists of
// rectangles at the cone; the distances are positive in a map, and lengths that allow none are found by themselves.
#include "hgp/optimize/lone_cones.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "along.h"
#include "hgp/features/step_repair.h"
#include "hgp/optimize/feature_lengths.h"
#include "hgp/parametrize/along/straight_setup.h"
#include "support/creases.h"

namespace hgp {
namespace {

/// The convex polyhedron of these vertices and outward normals of faces, every face with its centre and each of the triangles there
/// cut into n² triangles.
TriMesh polyhedron(const std::vector<Vec3>& corners, const std::vector<Vec3>& normals, int n) {
  MeshData data;
  std::map<std::array<long, 3>, int> ids;
  const auto idOf = [&](const Vec3& p) {
    const auto rounded = [&](int i) { return std::lround(1e6 * p[at(i)]); };
    const auto [it, isNew] = ids.try_emplace({rounded(0), rounded(1), rounded(2)},
                                             static_cast<int>(data.positions.size()));
    if (isNew) data.positions.push_back(p);
    return it->second;
  };
  for (const Vec3& normal : normals) {
    double reach = 0.0;
    for (const Vec3& p : corners) reach = std::max(reach, dot(p, normal));
    std::vector<Vec3> face;
    Vec3 centre{0.0, 0.0, 0.0};
    for (const Vec3& p : corners)
      if (dot(p, normal) > reach - 1e-9) face.push_back(p);
    for (const Vec3& p : face)
      centre = add(centre, scaled(p, 1.0 / static_cast<double>(face.size())));
    const Vec3 x = subtract(face[0], centre), y = cross(normal, x);
    std::sort(face.begin(), face.end(), [&](const Vec3& a, const Vec3& b) {
      const auto angle = [&](const Vec3& p) {
        return std::atan2(dot(subtract(p, centre), y) / norm(normal), dot(subtract(p, centre), x));
      };
      return angle(a) < angle(b);
    });
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Vec3 a = subtract(face[i], centre);
      const Vec3 b = subtract(face[(i + 1) % face.size()], centre);
      const auto id = [&](int j, int k) {
        return idOf(add(centre, add(scaled(a, j / double(n)), scaled(b, k / double(n)))));
      };
      for (int j = 0; j < n; ++j)
        for (int k = 0; j + k < n; ++k) {
          data.triangles.push_back({id(j, k), id(j + 1, k), id(j, k + 1)});
          if (j + k + 1 < n)
            data.triangles.push_back({id(j + 1, k), id(j + 1, k + 1), id(j, k + 1)});
        }
    }
  }
  return test::meshOf(data);
}

/// Signs of all coordinates, in all cyclic orders.
std::vector<Vec3> around(double x, double y, double z) {
  std::vector<Vec3> all;
  for (int signs = 0; signs < 8; ++signs) {
    const Vec3 p{signs & 1 ? -x : x, signs & 2 ? -y : y, signs & 4 ? -z : z};
    for (int turn = 0; turn < 3; ++turn) {
      const Vec3 q{p[at(turn)], p[at((turn + 1) % 3)], p[at((turn + 2) % 3)]};
      if (std::find(all.begin(), all.end(), q) == all.end()) all.push_back(q);
    }
  }
  return all;
}

TriMesh octahedron(int n) { return polyhedron(around(1, 0, 0), around(1, 1, 1), n); }

TriMesh dodecahedron(int n) {
  const double golden = 0.5 * (1.0 + std::sqrt(5.0));
  std::vector<Vec3> corners = around(1, 1, 1);
  for (const Vec3& p : around(0, 1.0 / golden, golden)) corners.push_back(p);
  return polyhedron(corners, around(0, golden, 1), n);
}

StraightSetup setupOf(PreparedSurface& surface, const std::vector<EdgeId>& features,
                      const HolonomySpec& spec = {}) {
  std::vector<StageTime> times;
  Result<StraightSetup> setup = prepareStraight(surface, features, spec, {}, times);
  EXPECT_TRUE(setup);
  return std::move(*setup);
}

/// A side of a patch for any values of the unknowns.
struct Side {
  double distance = 0.0;  ///< of the cone
  double length = 0.0;    ///< signed
  HalfedgeId next;
};

std::map<HalfedgeId, Side> sidesIn(const TriMesh& mesh, const StraightSetup& setup,
                                   const Eigen::VectorXd& x) {
  const Sectors& sectors = setup.aligned.sectors;
  const CutMesh& cut = setup.seamless.cut;
  const std::vector<Complex> z = placesOf(setup.unknowns, x);
  std::map<EdgeId, double> lengths;
  for (const StraightEdge& e : setup.edges)
    lengths[mesh.edge(e.h)] =
        (rotation(-e.heading, 4) * (z[at(cut.copy[TriMesh::next(e.h)].i)] - z[at(cut.copy[e.h].i)]))
            .real();
  std::map<HalfedgeId, Side> sides;
  for (const SideDistance& d : setup.distances) {
    Side& side = sides[d.side];
    for (const auto& [unknown, factor] : d.sum) side.distance += factor * x[unknown];
    const std::vector<HalfedgeId> run = straightRun(mesh, setup.aligned, d.side);
    EXPECT_EQ(run.front(), d.side);
    double onSurface = 0.0;
    for (const HalfedgeId h : run) {
      side.length += lengths.at(mesh.edge(h));
      onSurface += setup.seamless.context->geometry.length[h];
    }
    EXPECT_NEAR(d.length, 0.5 * onSurface, 1e-12 * onSurface);
    side.next = sectors.list[at(sectors.of[TriMesh::next(run.back())])].first;
  }
  return sides;
}

/// The rectangles at the cone.
void expectRectangles(const std::map<HalfedgeId, Side>& sides, double scale) {
  std::map<HalfedgeId, HalfedgeId> before;
  for (const auto& [h, side] : sides) before[side.next] = h;
  for (const auto& [h, side] : sides) {
    ASSERT_TRUE(sides.contains(side.next) && before.contains(h));
    const double both = sides.at(side.next).distance + sides.at(before.at(h)).distance;
    EXPECT_NEAR(side.length, both, 1e-9 * scale);
  }
}

TEST(LoneCones, EverySideIsAsLongAsTheDistancesFromItsNeighboursTogether) {
  for (const auto& [mesh, k] : {std::pair(octahedron(6), 3), std::pair(dodecahedron(3), 5)}) {
    PreparedSurface surface(mesh);
    const StraightSetup setup = setupOf(surface, test::creasesOf(mesh));
    EXPECT_EQ(setup.distances.size(), k == 3 ? 24u : 60u) << "one for every side";
    const SeamlessSystem system = systemOf(mesh, setup.seamless);
    StraightOptions options;
    options.u = setup.seamless.field.u;
    const StraightResult map = solveStraight(straightSystemOf(setup, system), {}, options);
    const std::map<HalfedgeId, Side> sides = sidesIn(mesh, setup, map.x);
    expectRectangles(sides, sides.begin()->second.length);
    for (const auto& [h, side] : sides) EXPECT_GT(side.distance, 0.0);
    const Result<Parametrization> run = test::along(mesh, test::creasesOf(mesh));
    ASSERT_TRUE(run);
    EXPECT_TRUE(run->isCertified) << k;
  }
}

/// The corners of a cube as cones.
HolonomySpec cornersOf(const TriMesh& mesh, const Sectors& sectors) {
  HolonomySpec spec;
  for (VertexId v : mesh.vertices()) {
    int creases = 0;
    for (HalfedgeId h : outgoingHalfedges(mesh, v)) creases += sectors.isFeature[mesh.edge(h)];
    if (creases == 3) spec.cones.push_back({v, 3});
  }
  EXPECT_EQ(spec.cones.size(), 8u);
  return spec;
}

TEST(LoneCones, SidesAreThatLongForAllValuesOfTheUnknownsAndOverAllSeams) {
  const TriMesh mesh = test::cube(4).mesh();
  const std::vector<EdgeId> features = test::creasesOf(mesh);
  const Sectors sectors = findSectors(mesh, features);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  int patches = 0, turned = 0;
  for (VertexId v : mesh.vertices()) {
    if (sectors.isOnFeature[v]) continue;
    HolonomySpec spec = cornersOf(mesh, sectors);
    spec.cones[at(v.i) % 8].vertex = v;
    PreparedSurface surface(mesh);
    std::vector<StageTime> times;
    const Result<StraightSetup> setup = prepareStraight(surface, features, spec, {}, times);
    if (!setup || setup->distances.empty()) continue;
    ++patches;
    Eigen::VectorXd x(setup->unknowns.count);
    for (double& one : x) one = value(random);
    expectRectangles(sidesIn(mesh, *setup, x), 1.0);
    for (const SideDistance& d : setup->distances)
      turned += mesh.halfedge(mesh.edge(d.side)) != d.side &&
                setup->seamless.seams.rotation[d.side] % 2 == 1;
  }
  EXPECT_GT(patches, 10);
  EXPECT_GT(turned, 0) << "no side is seen across a seam with a quarter turn";
}

TEST(LoneCones, OtherPatchesHaveNoDistances) {
  int rectangular = 0;
  for (const test::CreasedShape& shape : test::creasedShapes()) {
    PreparedSurface surface(shape.mesh);
    const StraightSetup setup = setupOf(surface, shape.features);
    const AlignedField& field = setup.aligned;
    bool isRectangular = true;
    for (VertexId v : shape.mesh.vertices())
      isRectangular = isRectangular && (field.sectors.isOnFeature[v] || field.index[at(v.i)] == 4);
    if (!isRectangular) continue;
    ++rectangular;
    EXPECT_TRUE(setup.distances.empty()) << shape.name;
  }
  EXPECT_GT(rectangular, 2);
}

TEST(LoneCones, ACornerOfACubeCannotMoveIntoAFace) {
  const TriMesh mesh = test::cube(6).mesh();
  const std::vector<EdgeId> features = test::creasesOf(mesh);
  const Sectors sectors = findSectors(mesh, features);
  HolonomySpec spec = cornersOf(mesh, sectors);
  const Vec3 corner = mesh.position(spec.cones[0].vertex);
  double nearest = 1e9;
  for (VertexId v : mesh.vertices()) {
    const double distance = norm(subtract(mesh.position(v), corner));
    bool isOff = !sectors.isOnFeature[v];
    for (HalfedgeId h : outgoingHalfedges(mesh, v))
      isOff = isOff && !sectors.isOnFeature[mesh.head(h)];
    if (!isOff || distance >= nearest) continue;
    spec.cones[0].vertex = v;  // of a face beside it
    nearest = distance;
  }
  PreparedSurface surface(mesh);
  const StraightSetup setup = setupOf(surface, features, spec);
  ASSERT_EQ(setup.distances.size(), 3u);
  const SeamlessSystem system = systemOf(mesh, setup.seamless);
  const LengthFit fit = fitLengths(straightSystemOf(setup, system));
  EXPECT_FALSE(fit.isPossible);
  EXPECT_GT(fit.excess, 0.1);
  EXPECT_FALSE(fit.edges.empty());
  // The sides are a + c, a + b and b + c long, and each of the first two lengths adds up to the third: b = 0.
  const std::vector<SideDistance> none;
  const StraightSystem free{system, setup.unknowns, setup.edges, none, setup.hasRow, *setup.tree};
  EXPECT_TRUE(fitLengths(free).isPossible);
  spec.features = features;
  const Result<Parametrization> run = parametrizeAlongFeatures(surface, spec, {});
  ASSERT_TRUE(run);
  EXPECT_FALSE(run->isCertified);
  EXPECT_EQ(run->rounds.size(), 1u) << "no other program is tried";
  const auto isContradiction = [](const Note& note) { return note.code == "features-contradict"; };
  EXPECT_TRUE(std::any_of(run->notes.begin(), run->notes.end(), isContradiction));
}

}  // namespace
}  // namespace hgp
