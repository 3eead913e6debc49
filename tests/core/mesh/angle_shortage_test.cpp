#include "hgp/mesh/angle_shortage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "hgp/base/phrase.h"
#include "hgp/base/turns.h"
#include "hgp/mesh/holonomy_spec.h"
#include "hgp/mesh/topology.h"
#include "support/random.h"
#include "support/shapes.h"

namespace hgp {
namespace {

PerVertex<int> regular(const TriMesh& mesh, int q) {
  return PerVertex<int>(static_cast<std::size_t>(mesh.vertexCount()), q);
}

/// A vertex of six triangles whose first neighbour has six.
VertexId regularPair(const TriMesh& mesh) {
  for (VertexId v : mesh.vertices())
    if (mesh.valence(v) == 6 && !mesh.isBoundary(mesh.head(mesh.outgoing(v))) &&
        mesh.valence(mesh.head(mesh.outgoing(v))) == 6)
      return v;
  return {};
}

TEST(AngleShortage, OfTwoNeighboursNamesTheirTenTriangles) {
  const TriMesh mesh = test::disk(8).mesh();  // whose boundary gives what is missing
  const VertexId a = regularPair(mesh), b = mesh.head(mesh.outgoing(a));
  PerVertex<int> k = regular(mesh, 4);
  k[a] = 10;
  k[b] = 9;
  EXPECT_FALSE(findAngleShortage(mesh, 4, k)) << "9.5π fit into ten triangles";
  k[b] = 10;
  const auto found = findAngleShortage(mesh, 4, k);
  ASSERT_TRUE(found) << "10π do not, with positive angles elsewhere";
  EXPECT_EQ(found->cones, (std::vector<VertexId>{std::min(a, b), std::max(a, b)}));
  EXPECT_EQ(found->vertices, 2);
  EXPECT_EQ(found->triangles, 10);
  EXPECT_NEAR(found->asked, 10.0 * kPi, 1e-9);
}

TEST(AngleShortage, NamedVerticesAskForAtLeastTheAnglesOfTheirTriangles) {
  // Σ_W Θ ≥ π |T| for what is found, whatever was asked.
  const TriMesh mesh = test::disk(8).mesh();
  std::mt19937 random(7);
  int found = 0;
  for (int draw = 0; draw < 200; ++draw) {
    PerVertex<int> k = regular(mesh, 3);
    for (int i = 0; i < 20; ++i) {
      const VertexId v{test::randomBelow(random, mesh.vertexCount())};
      k[v] = 1 + test::randomBelow(random, 8);
    }
    const auto shortage = findAngleShortage(mesh, 3, k);
    if (!shortage) continue;
    ++found;
    EXPECT_GE(shortage->asked, kPi * shortage->triangles - 1e-9);
    EXPECT_GE(shortage->vertices, static_cast<int>(shortage->cones.size()));
    EXPECT_TRUE(std::is_sorted(shortage->cones.begin(), shortage->cones.end(),
                               [&](VertexId a, VertexId b) { return k[a] > k[b]; }));
  }
  EXPECT_GE(found, 20);
  EXPECT_LT(found, 180);
}

TEST(AngleShortage, IsNotLookedForWithoutASteepConeAndBoundariesGiveWhatIsMissing) {
  const TriMesh sphere = test::icosphere(6).mesh();
  PerVertex<int> k = regular(sphere, 4);
  k[regularPair(sphere)] = 5;
  EXPECT_FALSE(findAngleShortage(sphere, 4, k));
  // The centre of a disk of six triangles: 5π of them, π left for the boundary.
  const TriMesh disk = test::disk(1).mesh();
  PerVertex<int> one = regular(disk, 2);
  for (VertexId v : disk.vertices())
    if (!disk.isBoundary(v)) one[v] = 5;
  EXPECT_FALSE(findAngleShortage(disk, 2, one));
}

/// Hall's condition over all sets of vertices of a closed surface: positive angles exist if and only if every
/// set but that of all vertices asks for less than its triangles hold.
bool hasRoom(const TriMesh& mesh, int q, const PerVertex<int>& k) {
  for (unsigned set = 1; set + 1 < 1U << mesh.vertexCount(); ++set) {
    long long asked = 0, triangles = 0;
    for (VertexId v : mesh.vertices()) asked += (set >> v.i & 1U) != 0 ? 2LL * k[v] : 0;
    for (FaceId f : mesh.faces()) {
      const auto corners = mesh.corners(f);
      triangles += std::any_of(corners.begin(), corners.end(),
                               [&](VertexId v) { return (set >> v.i & 1U) != 0; });
    }
    if (asked >= q * triangles) return false;
  }
  return true;
}

TEST(AngleShortage, FromEveryVertexIsFoundIfAndOnlyIfSomeSetOfVerticesHasOne) {
  std::mt19937 random(11);
  int found = 0, none = 0;
  for (const test::Shape& shape : {test::octahedron(), test::icosphere(1)}) {
    const TriMesh mesh = shape.mesh();
    for (int draw = 0; draw < 150; ++draw) {
      const int q = 3 + draw % 3;
      PerVertex<int> k(at(mesh.vertexCount()), 1);
      // Gauss–Bonnet: Σ k = q (V − 2).
      for (int rest = q * (mesh.vertexCount() - 2) - mesh.vertexCount(); rest > 0; --rest)
        ++k[VertexId(test::randomBelow(random, draw % 2 == 0 ? mesh.vertexCount() : 4))];
      const bool isShort = findAnyAngleShortage(mesh, {q, k, {}}).has_value();
      EXPECT_EQ(isShort, !hasRoom(mesh, q, k)) << shape.name << " draw " << draw;
      ++(isShort ? found : none);
    }
  }
  EXPECT_GE(found, 50);
  EXPECT_GE(none, 50);
}

TEST(AngleShortage, IsTheSameFromWhateverAnglesTheSearchStarts) {
  std::mt19937 random(12);
  int found = 0, none = 0;
  for (const test::Shape& shape : {test::octahedron(), test::icosphere(1), test::annulus(5, 3)}) {
    const TriMesh mesh = shape.mesh();
    for (int draw = 0; draw < 150; ++draw) {
      const int q = 3 + draw % 3;
      PerVertex<int> k(at(mesh.vertexCount()), 1);
      for (int rest = q * (mesh.vertexCount() - 2) - mesh.vertexCount(); rest > 0; --rest)
        ++k[VertexId(test::randomBelow(random, draw % 2 == 0 ? mesh.vertexCount() : 4))];
      int starts = 0;
      const NearAngles drawn = [&](const AngleQuestion&) -> std::optional<PerHalfedge<double>> {
        ++starts;
        PerHalfedge<double> out(at(mesh.halfedgeCount()), kPi / 3.0);
        // From a third in each corner to angles that are far from any triangle's.
        for (double& angle : out.raw())
          angle += (draw % 3) * (0.01 * test::randomBelow(random, 400) - 2.0);
        return out;
      };
      const auto alone = findAnyAngleShortage(mesh, {q, k, {}});
      const auto near = findAnyAngleShortage(mesh, {q, k, {}}, drawn);
      EXPECT_EQ(starts, 1);
      ASSERT_EQ(near.has_value(), alone.has_value()) << shape.name << " draw " << draw;
      if (near) {
        EXPECT_EQ(near->cones, alone->cones);
      }
      ++(near ? found : none);
      EXPECT_EQ(findAngleShortage(mesh, q, k, drawn).has_value(),
                findAngleShortage(mesh, q, k).has_value());
    }
  }
  EXPECT_GE(found, 50);
  EXPECT_GE(none, 50);
}

TEST(AngleShortage, OfManyWeakConesIsFoundFromEveryVertexOnly) {
  // All vertices within four edges of the centre: 61 · 2.5π, and 150 triangles. None is steep.
  const TriMesh mesh = test::disk(8).mesh();
  PerVertex<int> k = regular(mesh, 4);
  std::vector<VertexId> ball{VertexId(0)};
  for (std::size_t n = 0, end = 1, ring = 0; ring < 4; ++ring, end = ball.size())
    for (; n < end; ++n)
      for (HalfedgeId h : outgoingHalfedges(mesh, ball[n]))
        if (std::find(ball.begin(), ball.end(), mesh.head(h)) == ball.end())
          ball.push_back(mesh.head(h));
  for (const VertexId v : ball) k[v] = 5;
  EXPECT_FALSE(findAngleShortage(mesh, 4, k));
  const auto found = findAnyAngleShortage(mesh, {4, k, {}});
  ASSERT_TRUE(found);
  EXPECT_GE(found->asked, kPi * found->triangles - 1e-9);
  for (std::size_t n = 37; n < ball.size(); ++n) k[ball[n]] = 4;
  EXPECT_FALSE(findAnyAngleShortage(mesh, {4, k, {}})) << "37 · 2.5π fit into 96 triangles";
}

/// An annulus whose first rim asks for `turning`, and cones of k = 3 that balance it.
HolonomySpec steepRim(const TriMesh& mesh, int turning) {
  HolonomySpec spec;
  spec.turning = {turning, 0};
  for (VertexId v : mesh.vertices())
    if (!mesh.isBoundary(v) && static_cast<int>(spec.cones.size()) < -turning)
      spec.cones.push_back({v, 3});
  return spec;
}

TEST(AngleShortage, OfARimThatTurnsTooFar) {
  // Two triangles of each edge of the rim share three corners at it: 8 edges hold 16π, and the bound of turningRange,
  // which counts corners one by one, is 24π. Turning l asks for 8π − lπ/2.
  const TriMesh mesh = test::annulus(8, 6).mesh();
  const Topology topology = computeTopology(mesh);
  ASSERT_EQ(topology.loops.size(), 2u);
  for (const int turning : {-14, -16, -20}) {
    const HolonomySpec spec = steepRim(mesh, turning);
    const Result<BudgetReport> budget = checkPrescription(mesh, topology, spec);
    ASSERT_TRUE(budget) << budget.error().message;
    EXPECT_FALSE(budget->isTooCoarse) << "the search from steep cones does not look at rims";
    const std::optional<Note> proof = proveImpossible(mesh, topology, spec);
    EXPECT_EQ(proof.has_value(), turning <= -16) << turning;
    if (!proof) continue;
    EXPECT_EQ(proof->code, "angle-shortage");
    EXPECT_EQ(proof->where, (std::vector<Where>{{Where::Kind::kLoop, 0}}));
    const std::string sentence = phrase(*proof);
    const std::string rim = "the rim 0 (turning " + std::to_string(turning) + ")";
    for (const std::string& part : {rim, std::string("16 triangles"), std::string("--refine")})
      EXPECT_NE(sentence.find(part), std::string::npos) << sentence;
    HolonomySpec open = spec;
    open.turning[0].reset();
    EXPECT_TRUE(proveImpossible(mesh, topology, open)) << "all others determine how it turns";
    open.turning[1].reset();
    EXPECT_FALSE(proveImpossible(mesh, topology, open)) << "rims that may turn as they like";
  }
}

TEST(AngleShortage, IsAWarningOfTheCheckWithWhatToDo) {
  const TriMesh mesh = test::icosphere(6).mesh();
  const VertexId a = regularPair(mesh), b = mesh.head(mesh.outgoing(a));
  HolonomySpec spec;
  spec.cones = {{a, 10}, {b, 10}};
  for (int i = 0; spec.cones.size() < 12; i += 20)
    if (const VertexId v{i}; v != a && v != b) spec.cones.push_back({v, 2});
  const Result<BudgetReport> report = checkPrescription(mesh, computeTopology(mesh), spec);
  ASSERT_TRUE(report) << report.error().message;
  EXPECT_TRUE(report->isTooCoarse);
  ASSERT_FALSE(report->warnings.empty());
  EXPECT_EQ(report->warnings.back().code, "angle-shortage");
  EXPECT_EQ(report->warnings.back().where,
            (std::vector<Where>{{Where::Kind::kVertex, std::min(a.i, b.i)},
                                {Where::Kind::kVertex, std::max(a.i, b.i)}}));
  const std::string warning = phrase(report->warnings.back());
  for (const char* part :
       {"2 cones with k = 10, 10 (vertex ", "10π together", "10 triangles", "--refine"})
    EXPECT_NE(warning.find(part), std::string::npos) << warning;
}

}  // namespace
}  // namespace hgp
