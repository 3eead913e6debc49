// Lemmas 5.2, 5.3, 5.4 and 6.2 and Theorem 5.1 of [BCW17], on covers built for random prescriptions.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "hgp/optimize/program.h"
#include "hgp/verify/certificate.h"
#include "paper/branched_cover.h"
#include "support/seamless.h"

namespace hgp {
namespace {

const std::vector<test::CutSurface>& surfaces() {
  static const std::vector<test::CutSurface> all = test::makeCutSurfaces(109);
  return all;
}

/// Two cones on one edge may have several edges of the cover between the same two points, which a
/// vertex–vertex mesh cannot hold: those prescriptions are left out.
bool hasConeEdge(const test::CutSurface& s) {
  for (EdgeId e : s.mesh.edges()) {
    const HalfedgeId h = s.mesh.halfedge(e);
    if (s.isCone(s.mesh.tail(h)) && s.isCone(s.mesh.head(h))) return true;
  }
  return false;
}

template <class Law>
int forCovers(const Law& law) {
  int count = 0;
  for (const test::CutSurface& s : surfaces()) {
    if (hasConeEdge(s)) continue;
    SCOPED_TRACE(s.name);
    law(s, test::branchedCover(s.mesh, s.seams));
    ++count;
  }
  return count;
}

std::vector<std::vector<VertexId>> preimages(const test::CutSurface& s,
                                             const test::BranchedCover& cover) {
  std::vector<std::vector<VertexId>> above(static_cast<std::size_t>(s.mesh.vertexCount()));
  for (VertexId v : cover.mesh.vertices())
    above[static_cast<std::size_t>(cover.projection[static_cast<std::size_t>(v.i)].i)].push_back(v);
  return above;
}

TEST(Lemma52, RamificationPointsAboveAConeAreGcdOfKAndQ) {
  const int count = forCovers([](const test::CutSurface& s, const test::BranchedCover& cover) {
    const auto above = preimages(s, cover);
    const int q = s.seams.q;
    for (VertexId v : s.mesh.vertices()) {
      if (s.mesh.isBoundary(v)) continue;
      const auto& points = above[static_cast<std::size_t>(v.i)];
      const int k = s.k(v);  // q where there is no cone: q points of index 1
      EXPECT_EQ(static_cast<int>(points.size()), std::gcd(k, q));
      for (VertexId point : points)
        EXPECT_EQ(cover.mesh.valence(point), s.mesh.valence(v) * q / std::gcd(k, q));
    }
  });
  EXPECT_GT(count, 30);
}

TEST(Lemma53, BoundariesAboveALoopAreGcdOfLAndQ) {
  forCovers([](const test::CutSurface& s, const test::BranchedCover& cover) {
    const int q = s.seams.q;
    for (std::size_t j = 0; j < s.field.spec.turning.size(); ++j) {
      const int l = s.field.spec.turning[j], d = std::gcd(l, q);
      int components = 0;
      for (std::size_t i = 0; i < cover.loopProjection.size(); ++i) {
        if (cover.loopProjection[i].i != static_cast<int>(j)) continue;
        ++components;
        EXPECT_EQ(cover.topology.loops[i].halfedges.size(),
                  s.context.topology.loops[j].halfedges.size() * static_cast<std::size_t>(q / d));
      }
      EXPECT_EQ(components, d) << "l = " << l;
    }
  });
}

TEST(Theorem51, RiemannHurwitzGivesTheTopologyOfTheCover) {
  forCovers([](const test::CutSurface& s, const test::BranchedCover& cover) {
    const int q = s.seams.q;
    int euler = q * s.context.topology.eulerCharacteristic;
    for (const ConePoint& cone : s.field.spec.cones)  // Σ (e_P − 1) = q − gcd(k, q)
      euler -= q - std::gcd(cone.k, q);
    EXPECT_EQ(cover.topology.eulerCharacteristic, euler);
  });
}

TEST(Lemma62, HoldsForEveryCompletedPrescription) {
  for (const test::CutSurface& s : surfaces()) {
    const CompleteSpec& spec = s.field.spec;
    int left = spec.q * static_cast<int>(spec.cones.size());
    for (const ConePoint& cone : spec.cones) left -= cone.k;
    for (int l : spec.turning) left += l;
    const int m = static_cast<int>(spec.turning.size());
    EXPECT_EQ(left, spec.q * (2 - 2 * s.context.topology.genus - m)) << s.name;
  }
}

TEST(Lemma62, HoldsForTheMeasuredAnglesOfEveryPositiveMap) {
  // Discrete Gauss–Bonnet of the induced metric: no need for the angles to be the asked ones.
  std::mt19937 random(113);
  int measured = 0;
  for (const test::CutSurface& s : surfaces()) {
    const ReducedUnknowns unknowns = reduceUnknowns(s.mesh, s.cut, s.seams);
    const HarmonicSystem harmonic =
        harmonicSystem(s.mesh, s.context.geometry, s.cut, unknowns, s.seams.q, s.cones);
    ProgramOptions options;
    options.u = s.field.u;
    std::vector<FaceId> all;
    for (FaceId f : s.mesh.faces()) all.push_back(f);
    const ProgramResult result =
        solveProgram({s.mesh, s.context.geometry, s.cut, s.seams, unknowns, harmonic},
                     fieldFrames(s.seams, coneAndBoundaryFaces(s.mesh, s.cones)), options);
    UvMap map;
    for (const Complex& z : result.z) map.uv.push_back({z.real(), z.imag()});
    for (FaceId f : all) {
      std::array<int, 3> corners{};
      for (int k = 0; k < 3; ++k)
        corners[static_cast<std::size_t>(k)] = s.cut.copy[TriMesh::halfedge(f, k)].i;
      map.cornerUv.push_back(corners);
    }
    const Certificate c = certify(s.mesh, s.field.spec, map);
    if (!c.isMeasured || c.orientation.positive != s.mesh.faceCount()) continue;
    EXPECT_EQ(c.gaussBonnetHave, c.gaussBonnetNeed) << s.name;
    ++measured;
  }
  EXPECT_GT(measured, 40);
}

/// Lemma 5.4 and Appendix C on boundaries drawn by hand: a fan of triangles around nothing, given by
/// a closed polygon with a positively oriented collar.
TEST(Lemma54, ExteriorFaceAndBoundaryVerticesContributePhiPlusOne) {
  // An annulus whose uv wind ϕ times around: r e^{iϕt}; the outer loop turns by 2πϕ.
  for (int phi : {1, 2, 3}) {
    const int n = 24;
    const TriMesh mesh = test::annulus(n, 2).mesh();
    const auto s = test::cutSurface("annulus", mesh, [&] {
      HolonomySpec spec;
      spec.q = 1;
      spec.turning = {phi, -phi};
      const BoundaryLoop loop = computeTopology(mesh).loops[0];
      const Vec3& p = mesh.position(mesh.tail(loop.halfedges[0]));
      if (std::hypot(p[0], p[1]) < 1.5) spec.turning = {-phi, phi};
      return spec;
    }());
    ASSERT_TRUE(s);
    std::vector<Complex> z(static_cast<std::size_t>(s->cut.vertexCount()));
    // Lay the wound annulus along the disk S_c: angles continue across faces.
    std::vector<char> isSet(z.size(), 0);
    PerFace<char> isSeen(static_cast<std::size_t>(mesh.faceCount()), 0);
    std::vector<std::pair<FaceId, double>> stack{{FaceId(0), 0.0}};
    isSeen[FaceId(0)] = 1;
    const auto place = [&](VertexId v) {
      return Complex(mesh.position(v)[0], mesh.position(v)[1]);
    };
    while (!stack.empty()) {
      const auto [f, base] = stack.back();  // base: the winding angle of the face's first corner
      stack.pop_back();
      const Complex first = place(mesh.corners(f)[0]);
      for (int k = 0; k < 3; ++k) {
        const HalfedgeId h = TriMesh::halfedge(f, k);
        const Complex p = place(mesh.tail(h));
        const double angle = base + std::arg(p / first);
        z[static_cast<std::size_t>(s->cut.copy[h].i)] = std::polar(std::abs(p), phi * angle);
        isSet[static_cast<std::size_t>(s->cut.copy[h].i)] = 1;
        if (mesh.isBoundary(h) || s->cut.isSeam[mesh.edge(h)]) continue;
        const FaceId g = TriMesh::face(mesh.twin(h));
        if (isSeen[g]) continue;
        isSeen[g] = 1;
        stack.emplace_back(g, base + std::arg(place(mesh.corners(g)[0]) / first));
      }
    }
    const test::BranchedCover cover = test::branchedCover(mesh, s->seams);
    const std::vector<Complex> edges = test::liftedEdges(cover, s->cut, z);
    for (double direction : {0.31, 1.7, 3.9}) {
      const test::Indices indices =
          test::countIndices(cover, edges, std::cos(direction), std::sin(direction));
      for (std::size_t j = 0; j < cover.topology.loops.size(); ++j) {
        int contribution = indices.exterior[j];
        for (HalfedgeId h : cover.topology.loops[j].halfedges)
          contribution += indices.vertex[static_cast<std::size_t>(cover.mesh.tail(h).i)];
        const int l = s->field.spec.turning[static_cast<std::size_t>(cover.loopProjection[j].i)];
        EXPECT_EQ(contribution, l + 1) << "phi " << phi;
      }
    }
  }
}

}  // namespace
}  // namespace hgp
