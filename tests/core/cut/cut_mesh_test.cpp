#include "hgp/cut/cut_mesh.h"

#include <gtest/gtest.h>

#include <map>
#include <numeric>
#include <set>

#include "support/seamless.h"

namespace hgp {
namespace {

TEST(CutMesh, IsADisk) {
  EXPECT_GT(test::cutSurfaces().size(), 80u);
  for (const test::CutSurface& s : test::cutSurfaces()) {
    EXPECT_TRUE(isDisk(s.mesh, s.cut)) << s.name;
    // And the boundary of S_c is one closed curve through every copy of the seam.
    std::map<int, int> after;
    for (HalfedgeId h : s.mesh.halfedges()) {
      if (!s.mesh.isBoundary(h) && !s.cut.isSeam[s.mesh.edge(h)]) continue;
      EXPECT_TRUE(after.emplace(s.cut.copy[h].i, s.cut.copy[TriMesh::next(h)].i).second) << s.name;
    }
    if (after.empty()) {
      ADD_FAILURE() << s.name << ": no surface here is a disk without boundary";
      continue;
    }
    std::size_t length = 0;
    int at = after.begin()->first;
    do {
      at = after.at(at);
      ++length;
    } while (at != after.begin()->first && length <= after.size());
    EXPECT_EQ(length, after.size()) << s.name;
  }
}

TEST(CutMesh, WithoutASeamIsNoDiskUnlessTheSurfaceIsOne) {
  for (const test::Shape& shape : test::all()) {
    const TriMesh mesh = shape.mesh();
    const CutMesh cut =
        cutToDisk(mesh, PerEdge<char>(static_cast<std::size_t>(mesh.edgeCount()), 0), {});
    EXPECT_EQ(isDisk(mesh, cut), shape.genus == 0 && shape.loops == 1) << shape.name;
    EXPECT_EQ(cut.vertexCount(), mesh.vertexCount());
  }
}

TEST(CutMesh, InteriorSeamVertexOfDegreeDHasDCopies) {
  int branched = 0;
  for (const test::CutSurface& s : test::cutSurfaces()) {
    PerVertex<int> copies(static_cast<std::size_t>(s.mesh.vertexCount()), 0);
    for (VertexId v : s.cut.parent) ++copies[v];
    for (VertexId v : s.mesh.vertices()) {
      if (s.mesh.isBoundary(v)) continue;
      const int d = s.seamDegree(v);
      EXPECT_EQ(copies[v], std::max(d, 1)) << s.name << " vertex " << v.i;
      branched += d > 2;
    }
  }
  EXPECT_GT(branched, 30);
}

TEST(CutMesh, BoundaryVertexOfDegreeDHasDPlusOneCopies) {
  int cut = 0;
  for (const test::CutSurface& s : test::cutSurfaces()) {
    PerVertex<int> copies(static_cast<std::size_t>(s.mesh.vertexCount()), 0);
    for (VertexId v : s.cut.parent) ++copies[v];
    for (VertexId v : s.mesh.vertices()) {
      if (!s.mesh.isBoundary(v)) continue;
      EXPECT_EQ(copies[v], s.seamDegree(v) + 1) << s.name << " vertex " << v.i;
      cut += s.seamDegree(v) > 0;
    }
  }
  EXPECT_GT(cut, 30);
}

TEST(CutMesh, CornersShareACopyExactlyWithinASector) {
  for (const test::CutSurface& s : test::cutSurfaces()) {
    for (HalfedgeId h : s.mesh.halfedges()) {
      EXPECT_EQ(s.cut.parent[s.cut.copy[h]], s.mesh.tail(h));
      const HalfedgeId twin = s.mesh.twin(h);
      if (!twin.isValid()) continue;
      const bool isSame = s.cut.copy[h] == s.cut.copy[TriMesh::next(twin)] &&
                          s.cut.copy[TriMesh::next(h)] == s.cut.copy[twin];
      if (!s.cut.isSeam[s.mesh.edge(h)]) {
        EXPECT_TRUE(isSame) << s.name;
      }
    }
    std::set<int> used;
    for (HalfedgeId h : s.mesh.halfedges()) used.insert(s.cut.copy[h].i);
    EXPECT_EQ(static_cast<int>(used.size()), s.cut.vertexCount()) << s.name;
  }
}

TEST(CutMesh, CopiesFollowCounterclockwise) {
  for (const test::CutSurface& s : test::cutSurfaces()) {
    for (VertexId v : s.mesh.vertices()) {
      const int count = std::max(1, s.seamDegree(v) + (s.mesh.isBoundary(v) ? 1 : 0));
      for (HalfedgeId h : outgoingHalfedges(s.mesh, v)) {
        const HalfedgeId next = s.mesh.nextOutgoing(h);
        if (!next.isValid()) continue;
        const int a = s.cut.copy[h].i - s.cut.firstCopy[v].i;
        const int b = s.cut.copy[next].i - s.cut.firstCopy[v].i;
        const int step = s.cut.isSeam[s.mesh.edge(next)] ? 1 : 0;
        EXPECT_EQ(b, s.mesh.isBoundary(v) ? a + step : (a + step) % count) << s.name;
      }
    }
  }
}

TEST(SeamGraph, PassesEveryConeAndEveryLoopAndEndsNowhereElse) {
  for (const test::CutSurface& s : test::cutSurfaces()) {
    for (VertexId v : s.cones) EXPECT_GT(s.seamDegree(v), 0) << s.name;
    const auto& loops = s.context.topology.loops;
    const bool isDiskAlready =
        s.cones.empty() && loops.size() == 1 && s.context.topology.genus == 0;
    for (const BoundaryLoop& loop : loops) {
      int degree = 0;
      for (HalfedgeId h : loop.halfedges) degree += s.seamDegree(s.mesh.tail(h));
      EXPECT_EQ(degree > 0, !isDiskAlready) << s.name;
    }
    for (VertexId v : s.mesh.vertices())
      if (!s.mesh.isBoundary(v) && !s.isCone(v)) {
        EXPECT_NE(s.seamDegree(v), 1) << s.name;
      }
    for (EdgeId e : s.mesh.edges())
      if (s.mesh.isBoundary(s.mesh.halfedge(e))) {
        EXPECT_FALSE(s.cut.isSeam[e]) << s.name;
      }
  }
}

TEST(SeamGraph, IsNoLongerThanSpanningTheTerminalsOneByOne) {
  // Mehlhorn's tree is at most twice the shortest; a star from the first terminal is a fair rival.
  const TriMesh mesh = test::icosphere(6).mesh();
  const Result<FieldContext> context = prepareFields(mesh);
  std::vector<VertexId> cones;
  for (VertexId v : mesh.vertices())
    if (mesh.valence(v) == 5) cones.push_back(v);  // the icosahedron's own vertices
  ASSERT_EQ(cones.size(), 12u);
  const PerEdge<char> seam = seamGraph(mesh, context->geometry, context->surface, cones);
  const int edges = std::accumulate(seam.begin(), seam.end(), 0);
  EXPECT_EQ(edges, 11 * 6) << "a tree along the icosahedron's edges";
}

TEST(SeamGraph, HandlesAreOpenedAlongShortLoops) {
  // A torus of radii 1 and 0.4: once around the tube (2π · 0.4) and once around the hole (2π · 0.6).
  const TriMesh mesh = test::torus(40, 20).mesh();
  const Result<FieldContext> context = prepareFields(mesh);
  const Geometry& geometry = context->geometry;
  const PerEdge<char> seam = seamGraph(mesh, geometry, context->surface, {});
  double length = 0.0;
  for (EdgeId e : mesh.edges())
    if (seam[e]) length += geometry.length[mesh.halfedge(e)] * geometry.unit;
  EXPECT_LT(length, 1.3 * 2 * kPi * (0.4 + 0.6));
}

TEST(CutMesh, ChainsCoverTheSeamOnceAndEndAtNodes) {
  for (const test::CutSurface& s : test::cutSurfaces()) {
    std::vector<int> uses(static_cast<std::size_t>(s.mesh.edgeCount()), 0);
    for (std::size_t c = 0; c < s.cut.chains.size(); ++c) {
      const auto& left = s.cut.chains[c].left;
      ASSERT_FALSE(left.empty());
      EXPECT_TRUE(s.cut.isSeamNode[s.mesh.tail(left.front())]) << s.name;
      EXPECT_TRUE(s.cut.isSeamNode[s.mesh.head(left.back())]) << s.name;
      for (std::size_t i = 0; i < left.size(); ++i) {
        ++uses[static_cast<std::size_t>(s.mesh.edge(left[i]).i)];
        EXPECT_EQ(s.cut.chain[left[i]], static_cast<int>(c));
        EXPECT_EQ(s.cut.chain[s.mesh.twin(left[i])], static_cast<int>(c));
        if (i == 0) continue;
        EXPECT_EQ(s.mesh.head(left[i - 1]), s.mesh.tail(left[i]));
        EXPECT_FALSE(s.cut.isSeamNode[s.mesh.tail(left[i])]) << s.name;
      }
    }
    for (EdgeId e : s.mesh.edges())
      EXPECT_EQ(uses[static_cast<std::size_t>(e.i)], s.cut.isSeam[e] ? 1 : 0) << s.name;
  }
}

}  // namespace
}  // namespace hgp
