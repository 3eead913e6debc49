#include "hgp/mesh/angle_shortage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

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
  const std::string& warning = report->warnings.back();
  for (const char* part : {"2 vertices", "(k=10)", "10π", "10 triangles", "--refine"})
    EXPECT_NE(warning.find(part), std::string::npos) << warning;
}

}  // namespace
}  // namespace hgp
