#include "hgp/mesh/topology.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

#include "support/shapes.h"

namespace hgp {
namespace {

TEST(Topology, KnowsGenusLoopsAndEulerCharacteristicOfEveryShape) {
  for (const test::Shape& shape : test::all()) {
    const Topology t = computeTopology(shape.mesh());
    EXPECT_EQ(t.componentCount, 1) << shape.name;
    EXPECT_EQ(t.genus, shape.genus) << shape.name;
    EXPECT_EQ(static_cast<int>(t.loops.size()), shape.loops) << shape.name;
    EXPECT_EQ(t.eulerCharacteristic, shape.eulerCharacteristic()) << shape.name;
    EXPECT_EQ(t.isolatedVertexCount, 0);
  }
}

TEST(Topology, LoopsRunAlongTheBoundaryWithTheSurfaceOnTheLeft) {
  for (const test::Shape& shape : test::withBoundary()) {
    const TriMesh mesh = shape.mesh();
    const Topology t = computeTopology(mesh);
    std::set<HalfedgeId> seen;
    HalfedgeId last;
    for (const BoundaryLoop& loop : t.loops) {
      ASSERT_GE(loop.halfedges.size(), 3u);
      EXPECT_GT(loop.halfedges[0], last) << "loops ascend by their smallest halfedge";
      last = loop.halfedges[0];
      for (std::size_t n = 0; n < loop.halfedges.size(); ++n) {
        const HalfedgeId h = loop.halfedges[n];
        EXPECT_TRUE(mesh.isBoundary(h));
        EXPECT_EQ(mesh.head(h), mesh.tail(loop.halfedges[(n + 1) % loop.halfedges.size()]));
        EXPECT_TRUE(seen.insert(h).second);
        EXPECT_LE(loop.halfedges[0], h);
      }
    }
    for (HalfedgeId h : mesh.halfedges()) EXPECT_EQ(mesh.isBoundary(h), seen.count(h) == 1);
  }
}

/// Rank over Z_p of 1-cochains on the dual graph: closed loops are independent in homology of the
/// surface with filled boundary iff no combination is a boundary.
int rankModuloBoundaries(const TriMesh& mesh, const std::vector<DualLoop>& loops) {
  // Integrate each loop as a Z_p chain of crossed edges; vertices' links and boundary loops' links
  // are the relations. Rank(loops + relations) − rank(relations).
  constexpr long long p = 1000003;
  std::vector<std::map<int, long long>> rows;
  const auto add = [&](std::map<int, long long>& row, HalfedgeId h, long long s) {
    const EdgeId e = mesh.edge(h);
    const long long sign = h == mesh.halfedge(e) ? s : -s;
    long long& x = row[e.i];
    x = ((x + sign) % p + p) % p;
    if (x == 0) row.erase(e.i);
  };
  std::map<int, std::map<int, long long>> pivots;
  const auto reduce = [&](std::map<int, long long> row) {
    while (!row.empty()) {
      const int c = row.begin()->first;
      const auto pivot = pivots.find(c);
      if (pivot == pivots.end()) {
        long long inverse = 1, base = row.begin()->second;
        for (long long e = p - 2; e; e >>= 1, base = base * base % p)
          if (e & 1) inverse = inverse * base % p;
        for (auto& [i, x] : row) x = x * inverse % p;
        pivots.emplace(c, std::move(row));
        return true;
      }
      const long long factor = row.begin()->second;
      for (const auto& [i, x] : pivot->second) {
        long long& y = row[i];
        y = ((y - factor * x) % p + p) % p;
        if (y == 0) row.erase(i);
      }
    }
    return false;
  };
  for (VertexId v : mesh.vertices()) {
    if (mesh.isBoundary(v)) continue;
    std::map<int, long long> row;
    for (HalfedgeId h : outgoingHalfedges(mesh, v)) add(row, h, 1);
    reduce(std::move(row));
  }
  for (const BoundaryLoop& loop : computeTopology(mesh).loops) {
    // The curve just inside the loop: all inner edges at its vertices, seen from the loop.
    std::map<int, long long> row;
    for (HalfedgeId b : loop.halfedges)
      for (HalfedgeId h : outgoingHalfedges(mesh, mesh.tail(b)))
        if (!mesh.isBoundary(h)) add(row, h, 1);
    reduce(std::move(row));
  }
  int rank = 0;
  for (const DualLoop& loop : loops) {
    std::map<int, long long> row;
    for (HalfedgeId h : loop.crossed) add(row, h, 1);
    rank += reduce(std::move(row));
  }
  return rank;
}

TEST(Topology, HandleGeneratorsAreClosedWalksAndABasisOfTheHandles) {
  for (const test::Shape& shape : test::all()) {
    const TriMesh mesh = shape.mesh();
    const std::vector<DualLoop> loops = handleGenerators(mesh);
    ASSERT_EQ(static_cast<int>(loops.size()), 2 * shape.genus) << shape.name;
    for (const DualLoop& loop : loops) {
      ASSERT_FALSE(loop.crossed.empty());
      for (std::size_t n = 0; n < loop.crossed.size(); ++n) {
        const HalfedgeId next = loop.crossed[(n + 1) % loop.crossed.size()];
        ASSERT_TRUE(mesh.twin(loop.crossed[n]).isValid());
        EXPECT_EQ(TriMesh::face(mesh.twin(loop.crossed[n])), TriMesh::face(next));
      }
    }
    EXPECT_EQ(rankModuloBoundaries(mesh, loops), 2 * shape.genus) << shape.name;
  }
}

TEST(Topology, GeneratorsDependOnConnectivityAlone) {
  const test::Shape shape = test::doubleTorus(2);
  const auto a = handleGenerators(shape.mesh()),
             b = handleGenerators(test::jittered(shape, 0.2).mesh());
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t n = 0; n < a.size(); ++n) EXPECT_EQ(a[n].crossed, b[n].crossed);
}

TEST(Topology, ComponentsAreTakenApartAndKnowWhereTheyComeFrom) {
  // Three shapes with their vertices and faces mixed at random, and two isolated vertices.
  const std::vector<test::Shape> parts{test::cube(2), test::torus(4, 3), test::disk(2)};
  MeshData data;
  std::vector<int> partOfFace, partOfVertex;
  for (std::size_t n = 0; n < parts.size(); ++n) {
    const int shift = static_cast<int>(data.positions.size());
    for (const Vec3& x : parts[n].data.positions) data.positions.push_back(x);
    for (auto t : parts[n].data.triangles)
      data.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  }
  data.positions.insert(data.positions.begin() + 3, {9, 9, 9});
  for (auto& t : data.triangles)
    for (int& v : t) v += v >= 3;
  data.positions.push_back({8, 8, 8});
  std::mt19937 random(9);
  for (std::size_t f = data.triangles.size(); f > 1; --f)
    std::swap(data.triangles[f - 1], data.triangles[random() % f]);

  const TriMesh mesh = test::meshOf(data);
  const Topology topology = computeTopology(mesh);
  EXPECT_EQ(topology.componentCount, 3);
  EXPECT_EQ(topology.isolatedVertexCount, 2);
  EXPECT_EQ(topology.genus, 1);
  EXPECT_EQ(topology.eulerCharacteristic, 3);
  const std::vector<Component> components = splitComponents(data, mesh, topology);
  ASSERT_EQ(components.size(), 3u);
  std::size_t faces = 0, vertices = 0;
  for (const Component& c : components) {
    EXPECT_TRUE(std::is_sorted(c.faceOrigin.begin(), c.faceOrigin.end()));
    EXPECT_TRUE(std::is_sorted(c.vertexOrigin.begin(), c.vertexOrigin.end()));
    faces += c.faceOrigin.size();
    vertices += c.vertexOrigin.size();
    EXPECT_EQ(computeTopology(test::meshOf(c.mesh)).componentCount, 1);
    for (std::size_t f = 0; f < c.faceOrigin.size(); ++f)
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_EQ(c.vertexOrigin[static_cast<std::size_t>(c.mesh.triangles[f][k])],
                  data.triangles[static_cast<std::size_t>(c.faceOrigin[f])][k]);
    for (std::size_t v = 0; v < c.vertexOrigin.size(); ++v)
      EXPECT_EQ(c.mesh.positions[v], data.positions[static_cast<std::size_t>(c.vertexOrigin[v])]);
  }
  EXPECT_EQ(faces, data.triangles.size());
  EXPECT_EQ(vertices, data.positions.size() - 2);
}

}  // namespace
}  // namespace hgp
