// The three examples of [BCW17 Fig. 7], with the numbers printed there and in §5.2, §6.1.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "hgp/optimize/program.h"
#include "hgp/parametrize/seamless_setup.h"
#include "hgp/verify/certificate.h"
#include "paper/branched_cover.h"
#include "support/shapes.h"

namespace hgp {
namespace {

/// A certified map of the example and its cover.
struct Example {
  TriMesh mesh;
  SeamlessSetup setup;
  std::vector<Complex> z;
  Certificate certificate;
  test::BranchedCover cover;
};

Example exampleOf(const test::Shape& shape, const HolonomySpec& spec) {
  Example e;
  e.mesh = shape.mesh();
  std::vector<StageTime> times;
  PreparedSurface surface(e.mesh);
  Result<SeamlessSetup> setup = prepareSeamless(surface, spec, {}, times);
  EXPECT_TRUE(setup) << setup.error().message;
  e.setup = std::move(*setup);
  ProgramOptions options;
  options.u = e.setup.field.u;
  const Frames frames = fieldFrames(e.setup.seams, coneAndBoundaryFaces(e.mesh, e.setup.cones));
  e.z = solveProgram(systemOf(e.mesh, e.setup), frames, options).z;
  e.certificate = certify(e.mesh, e.setup.field.spec, layOut(e.mesh, e.setup, e.z));
  EXPECT_TRUE(e.certificate.isCertified);
  e.cover = test::branchedCover(e.mesh, e.setup.seams);
  return e;
}

/// A: a disk with one cone of 3π/2, q = 4.
Example exampleA() {
  HolonomySpec spec;
  spec.cones = {{VertexId(0), 3}};
  return exampleOf(test::disk(4), spec);
}
/// B: a disk with one cone of π.
Example exampleB() {
  HolonomySpec spec;
  spec.cones = {{VertexId(0), 2}};
  return exampleOf(test::disk(4), spec);
}
/// C: a torus with one boundary loop and two cones of 5π/2.
Example exampleC() {
  const test::Shape shape = test::puncturedTorus(14, 9);
  const TriMesh mesh = shape.mesh();
  std::vector<VertexId> inner;
  const BoundaryLoop loop = computeTopology(mesh).loops[0];
  const auto distance = [&](VertexId a, VertexId b) {
    const Vec3 &p = mesh.position(a), &r = mesh.position(b);
    return std::hypot(p[0] - r[0], p[1] - r[1], p[2] - r[2]);
  };
  for (VertexId v : mesh.vertices())
    if (distance(v, mesh.tail(loop.halfedges[0])) > 0.9) inner.push_back(v);
  HolonomySpec spec;
  spec.cones = {{inner.front(), 5}, {inner.back(), 5}};
  for (VertexId v : inner)  // as far apart as can be
    if (distance(v, inner.front()) > distance(spec.cones[1].vertex, inner.front()))
      spec.cones[1].vertex = v;
  return exampleOf(shape, spec);
}

/// Preimages of a vertex of S with their ramification indices.
std::vector<int> ramification(const Example& e, VertexId v) {
  std::vector<int> indices;
  for (VertexId above : e.cover.mesh.vertices())
    if (e.cover.projection[static_cast<std::size_t>(above.i)] == v)
      indices.push_back(e.cover.mesh.valence(above) / e.mesh.valence(v));
  return indices;
}

TEST(Figure7, ExampleAHasOneRamificationPointAndOneBoundary) {
  const Example e = exampleA();
  EXPECT_EQ(e.setup.field.spec.turning, std::vector<int>{3});
  EXPECT_EQ(ramification(e, VertexId(0)), std::vector<int>{4});
  EXPECT_EQ(e.cover.topology.componentCount, 1);
  EXPECT_EQ(e.cover.topology.loops.size(), 1u);
  EXPECT_EQ(e.cover.topology.eulerCharacteristic, 1) << "a disk, wound up four times";
}

TEST(Figure7, ExampleBIsTwoDisjointDisks) {
  const Example e = exampleB();
  EXPECT_EQ(e.setup.field.spec.turning, std::vector<int>{2});
  EXPECT_EQ(ramification(e, VertexId(0)), (std::vector<int>{2, 2}));
  EXPECT_EQ(e.cover.topology.componentCount, 2);
  EXPECT_EQ(e.cover.topology.loops.size(), 2u);
  EXPECT_EQ(e.cover.topology.eulerCharacteristic, 2);
  EXPECT_EQ(e.cover.topology.genus, 0);
}

TEST(Figure7, ExampleCIsATwicePuncturedSurfaceOfGenusFive) {
  const Example e = exampleC();
  EXPECT_EQ(computeTopology(e.mesh).eulerCharacteristic, -1);
  EXPECT_EQ(e.setup.field.spec.turning, std::vector<int>{-2}) << "turning angle −π";
  for (VertexId cone : e.setup.cones) EXPECT_EQ(ramification(e, cone), std::vector<int>{4});
  EXPECT_EQ(e.cover.topology.loops.size(), 2u);
  EXPECT_EQ(e.cover.topology.eulerCharacteristic, -10);
  EXPECT_EQ(e.cover.topology.genus, 5);
  EXPECT_EQ(e.cover.topology.componentCount, 1);
}

/// The index count of §6: RHS of (5) is (9), the left-hand side (10); s must vanish.
void expectIndexCount(const Example& e) {
  const int q = e.setup.seams.q;
  const CompleteSpec& spec = e.setup.field.spec;
  const std::vector<Complex> edges = test::liftedEdges(e.cover, e.setup.cut, e.z);
  int rhs = 0, cones = 0, boundaries = 0;
  for (const ConePoint& cone : spec.cones) {
    rhs += std::gcd(cone.k, q) - cone.k;
    cones += std::gcd(cone.k, q) - cone.k;
  }
  for (int l : spec.turning) {
    rhs += std::gcd(l, q) + l;
    boundaries += std::gcd(l, q) + l;
  }
  for (double angle : {0.1234, 1.0, 2.5, 4.0}) {
    const test::Indices indices =
        test::countIndices(e.cover, edges, std::cos(angle), std::sin(angle));
    EXPECT_EQ(indices.sum(), rhs) << "(9)";
    EXPECT_EQ(e.cover.topology.eulerCharacteristic + static_cast<int>(indices.exterior.size()), rhs)
        << "χ of the cover closed by its exterior faces";
    int s = 0, atCones = 0, atBoundaries = 0;
    PerVertex<char> isCone(static_cast<std::size_t>(e.mesh.vertexCount()), 0);
    for (VertexId v : e.setup.cones) isCone[v] = 1;
    for (VertexId v : e.cover.mesh.vertices()) {
      const int index = indices.vertex[static_cast<std::size_t>(v.i)];
      if (e.cover.mesh.isBoundary(v)) {
        atBoundaries += index;
      } else if (isCone[e.cover.projection[static_cast<std::size_t>(v.i)]]) {
        atCones += index;
      } else {
        EXPECT_EQ(index, 0) << "interior vertices are wheel";
        s += index;
      }
    }
    for (int index : indices.face) {
      EXPECT_EQ(index, 0) << "a non-vanishing 1-form changes sign twice around a triangle";
      s += index;
    }
    for (int index : indices.exterior) atBoundaries += index;
    EXPECT_EQ(s, 0);
    EXPECT_EQ(atCones, cones) << "Σ gcd(k, q) − k";
    EXPECT_EQ(atBoundaries, boundaries) << "Σ gcd(l, q) + l";
  }
}

TEST(Figure7, IndexCountOfExampleAIsThatOfSection61) {
  const Example e = exampleA();
  expectIndexCount(e);
  // RHS = 4(1) − 3 + 1 = 2, LHS = s + (−2) + 4.
  const test::Indices indices =
      test::countIndices(e.cover, test::liftedEdges(e.cover, e.setup.cut, e.z), 0.6, 0.8);
  EXPECT_EQ(indices.sum(), 2);
}

TEST(Figure7, IndexCountsOfExamplesBAndC) {
  expectIndexCount(exampleB());
  expectIndexCount(exampleC());
}

}  // namespace
}  // namespace hgp
