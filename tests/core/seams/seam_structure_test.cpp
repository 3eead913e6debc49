// Chains and copies of seams.  Laws: chains partition the seam edges; every copy of a map is where its place says,
// for every q that a ring contains; what is not shared as copies are is refused.
#include "hgp/seams/seam_structure.h"

#include <gtest/gtest.h>

#include <set>

#include "hgp/system/reduced_unknowns.h"
#include "support/seamless.h"

namespace hgp {
namespace {

/// Any map that satisfies the seam conditions, not injective.
UvMap anyMap(const test::CutSurface& s, std::mt19937& random) {
  const ReducedUnknowns unknowns = reduceUnknowns(s.mesh, s.cut, s.seams);
  Eigen::VectorXcd x(unknowns.count);
  for (Complex& value : x) value = {test::randomReal(random), test::randomReal(random)};
  const Eigen::VectorXcd z = unknowns.copies * x;
  UvMap map;
  for (const Complex& value : z) map.uv.push_back({value.real(), value.imag()});
  map.cornerUv.resize(at(s.mesh.faceCount()));
  for (HalfedgeId h : s.mesh.halfedges()) map.cornerUv[at(h.i / 3)][at(h.i % 3)] = s.cut.copy[h].i;
  return map;
}

Complex at2(const UvMap& map, int copy) { return {map.uv[at(copy)][0], map.uv[at(copy)][1]}; }

template <class Ring>
void expectPlaces(const test::CutSurface& s, std::mt19937& random) {
  const UvMap map = anyMap(s, random);
  const auto seams = readSeamsOver<Ring>(s.mesh, map, s.seams.q, s.cones);
  ASSERT_TRUE(seams) << s.name;
  EXPECT_EQ(seams->chainCount(), s.cut.chainCount()) << s.name;
  const int step = Ring::kOrder / s.seams.q;
  for (int c = 0; c < seams->chainCount(); ++c)
    EXPECT_EQ(seams->chainTurn[at(c)], step * s.seams.rotation[seams->chains[at(c)].left[0]])
        << s.name;
  const std::vector<Complex> t = chainTranslations(*seams, s.mesh, map.uv);
  const auto placed = [&](const CopyPlace<Ring>& place, const Complex& first) {
    Complex z = toComplex(Ring::turned(place.turn)) * first;
    for (const auto& term : place.shift) z += toComplex(term.factor) * t[at(term.variable)];
    return z;
  };
  for (HalfedgeId h : s.mesh.halfedges()) {
    const Complex first = at2(map, seams->firstCopy[s.mesh.tail(h)]);
    const int copy = seams->copy[h];
    EXPECT_LT(std::abs(placed(seams->place(copy), first) - at2(map, copy)), 1e-10) << s.name;
  }
  for (const auto& closure : seams->closures) {
    const Complex first = at2(map, seams->firstCopy[closure.vertex]);
    EXPECT_LT(std::abs(placed(closure.place, first) - first), 1e-10) << s.name;
  }
}

TEST(SeamStructure, CopiesAreWhereTheirPlacesSay) {
  std::mt19937 random(23);
  int gaussian = 0, eisenstein = 0;
  for (const test::CutSurface& s : test::cutSurfaces()) {
    if (Gaussian::kOrder % s.seams.q == 0) {
      expectPlaces<Gaussian>(s, random);
      ++gaussian;
    }
    if (Eisenstein::kOrder % s.seams.q == 0) {
      expectPlaces<Eisenstein>(s, random);
      ++eisenstein;
    }
  }
  EXPECT_GT(gaussian, 20);
  EXPECT_GT(eisenstein, 20);
}

TEST(SeamStructure, OrdersThatARingDoesNotContainAreRefused) {
  const test::CutSurface& s = test::cutSurfaces().front();
  std::mt19937 random(29);
  const UvMap map = anyMap(s, random);
  for (const int q : {0, 3, 5, 6, 8}) EXPECT_FALSE(readSeams(s.mesh, map, q, s.cones)) << q;
  for (const int q : {4, 5, 12}) EXPECT_FALSE(readSeamsOver<Eisenstein>(s.mesh, map, q, s.cones));
}

TEST(SeamStructure, CopiesThatSectorsShareOrOfOtherVerticesAreRefused) {
  std::mt19937 random(31);
  int shared = 0;
  for (const test::CutSurface& s : test::cutSurfaces()) {
    if (s.seams.q != 4) continue;
    const UvMap map = anyMap(s, random);
    ASSERT_TRUE(readSeams(s.mesh, map, 4, s.cones));
    UvMap outside = map;
    outside.cornerUv[0][1] = static_cast<int>(map.uv.size());
    EXPECT_FALSE(readSeams(s.mesh, outside, 4, s.cones));
    UvMap ofOther = map;
    ofOther.cornerUv[0][1] = ofOther.cornerUv[0][2];
    EXPECT_FALSE(readSeams(s.mesh, ofOther, 4, s.cones));
    // All corners of a node with three copies or more use its first and its last one only.
    for (VertexId v : s.mesh.vertices()) {
      if (s.mesh.isIsolated(v) || s.mesh.isBoundary(v) || s.seamDegree(v) < 4) continue;
      UvMap joined = map;
      for (HalfedgeId h : outgoingHalfedges(s.mesh, v))
        if (s.cut.copy[h].i == s.cut.firstCopy[v].i + 2)
          joined.cornerUv[at(h.i / 3)][at(h.i % 3)] = s.cut.firstCopy[v].i;
      EXPECT_FALSE(readSeams(s.mesh, joined, 4, s.cones)) << s.name;
      ++shared;
      break;
    }
  }
  EXPECT_GT(shared, 0);
}

TEST(SeamChains, EndExactlyAtNodesAndHoldEverySeamEdgeOnce) {
  for (const test::CutSurface& s : test::cutSurfaces()) {
    PerEdge<char> isSeen(at(s.mesh.edgeCount()), 0);
    for (const SeamChain& chain : s.cut.chains)
      for (HalfedgeId h : chain.left) {
        EXPECT_TRUE(s.cut.isSeam[s.mesh.edge(h)] && !isSeen[s.mesh.edge(h)]) << s.name;
        EXPECT_TRUE(s.cut.isLeft[h] && !s.cut.isLeft[s.mesh.twin(h)]) << s.name;
        isSeen[s.mesh.edge(h)] = 1;
        EXPECT_EQ(s.cut.isSeamNode[s.mesh.tail(h)] != 0, h == chain.left.front()) << s.name;
        EXPECT_EQ(s.cut.isSeamNode[s.mesh.head(h)] != 0, h == chain.left.back()) << s.name;
      }
    EXPECT_EQ(isSeen.raw(), s.cut.isSeam.raw()) << s.name;
  }
}

TEST(SeamChains, AClosedOneWithoutANodeGetsOne) {
  // The link of a vertex, as a seam.
  const TriMesh mesh = test::icosphere(2).mesh();
  PerEdge<char> isSeam(at(mesh.edgeCount()), 0);
  std::size_t length = 0;
  for (HalfedgeId h : outgoingHalfedges(mesh, VertexId(0))) {
    isSeam[mesh.edge(TriMesh::next(h))] = 1;
    ++length;
  }
  const PerVertex<char> nodes = seamNodes(mesh, isSeam, {});
  EXPECT_EQ(std::count(nodes.begin(), nodes.end(), 1), 0);
  const SeamChains traced = traceChains(mesh, isSeam, nodes);
  ASSERT_EQ(traced.chainCount(), 1);
  EXPECT_EQ(traced.chains[0].left.size(), length);
  EXPECT_EQ(std::count(traced.isSeamNode.begin(), traced.isSeamNode.end(), 1), 1);
}

TEST(SeamChains, OfEdgesEndWhereSeamsBranchOrTheirRotationChanges) {
  // The link of a vertex has no branch; a spoke gives it one.
  const TriMesh mesh = test::icosphere(2).mesh();
  std::vector<EdgeId> edges;
  for (HalfedgeId h : outgoingHalfedges(mesh, VertexId(0)))
    edges.push_back(mesh.edge(TriMesh::next(h)));
  const std::size_t n = edges.size();
  ASSERT_GE(n, 5U);
  const auto chains = [&](const std::vector<int>& turn) {
    return chainsOfEdges(mesh, edges, turn, 4);
  };
  std::vector<int> turn(n, 1);
  EXPECT_EQ(chains(turn), std::vector<int>(n, 0));
  turn[1] = 3;  // 1 and 3 are one turn
  EXPECT_EQ(chains(turn), std::vector<int>(n, 0));
  turn[2] = 2;
  std::vector<int> expected(n, 0);
  expected[2] = 1;
  EXPECT_EQ(chains(turn), expected);
  turn[2] = 1;
  edges.push_back(
      mesh.edge(mesh.outgoing(VertexId(0))));  // a spoke: its outer end has three seam edges
  turn.push_back(1);
  const std::vector<int> branched = chains(turn);
  EXPECT_EQ(std::set<int>(branched.begin(), branched.end()), (std::set<int>{0, 1}));
  EXPECT_EQ(branched.back(), 1);
}

}  // namespace
}  // namespace hgp
