// Theorem 6.1 of [BCW17] both ways: a q-CCM with positive cone and boundary triangles and the desired
// angles is locally injective; a map that breaks a hypothesis is caught.
#include <gtest/gtest.h>

#include <cmath>

#include "hgp/optimize/program.h"
#include "hgp/parametrize/parametrize.h"
#include "hgp/system/harmonic_residual.h"
#include "hgp/verify/certificate.h"
#include "support/seamless.h"

namespace hgp {
namespace {

struct Solved {
  test::CutSurface surface;
  ProgramResult program;
  UvMap map;
  Certificate certificate;
  double relativeEnergy = 0.0;  ///< ‖Lz‖² against Σ|f_z|²
};

std::optional<Solved> solvedOf(const std::string& name, const TriMesh& mesh,
                               const HolonomySpec& spec, double tieBreak = 1e-10) {
  auto cut = test::cutSurface(name, mesh, spec);
  if (!cut) return {};
  Solved s{std::move(*cut), {}, {}, {}, 0.0};
  const test::CutSurface& c = s.surface;
  const ReducedUnknowns unknowns = reduceUnknowns(c.mesh, c.cut, c.seams);
  const HarmonicSystem harmonic =
      harmonicSystem(c.mesh, c.context.geometry, c.cut, unknowns, c.seams.q, c.cones);
  ProgramOptions options;
  options.u = c.field.u;
  options.tieBreak = tieBreak;
  s.program = solveProgram({c.mesh, c.context.geometry, c.cut, c.seams, unknowns, harmonic},
                           fieldFrames(c.seams, coneAndBoundaryFaces(c.mesh, c.cones)), options);
  for (const Complex& z : s.program.z) s.map.uv.push_back({z.real(), z.imag()});
  double size = 0.0;
  for (FaceId f : c.mesh.faces()) {
    std::array<int, 3> corners{};
    const LinearParts parts = linearParts(c.context.geometry, f);
    Complex similarity = 0.0;
    for (int k = 0; k < 3; ++k) {
      const int copy = c.cut.copy[TriMesh::halfedge(f, k)].i;
      corners[static_cast<std::size_t>(k)] = copy;
      similarity += parts.similarity[static_cast<std::size_t>(k)] *
                    s.program.z[static_cast<std::size_t>(copy)];
    }
    size += std::norm(similarity);
    s.map.cornerUv.push_back(corners);
  }
  s.certificate = certify(c.mesh, c.field.spec, s.map);
  s.relativeEnergy = s.program.laplacianEnergy / size;
  return s;
}

/// Hypotheses of the theorem, as measured.
bool hypothesesHold(const Solved& s) {
  const OrientationFacts& o = s.certificate.orientation;
  if (o.constrainedPositive != o.constrained) return false;
  for (const MeasuredCone& cone : s.certificate.angles.cones)
    if (s.surface.isCone(cone.vertex) && cone.measured != cone.asked) return false;
  for (const MeasuredTurning& t : s.certificate.angles.turnings)
    if (t.isWrong) return false;
  return true;
}

TEST(Theorem61, HarmonicMapsThatMeetTheHypothesesAreLocallyInjective) {
  std::mt19937 random(127);
  int harmonic = 0, applies = 0;
  for (const test::Shape& shape :
       {test::icosphere(3), test::disk(4), test::annulus(10, 3), test::torus(9, 6),
        test::jittered(test::icosphere(3), 0.05), test::withoutFaces(test::icosphere(3), {0, 90}),
        test::jittered(test::disk(6), 0.04), test::cube(3)}) {
    const TriMesh mesh = shape.mesh();
    const Topology topology = computeTopology(mesh);
    for (const auto& [q, cones] : {std::pair{4, 0}, {4, 2}, {3, 3}, {6, 3}, {2, 4}, {4, 5}}) {
      for (int draw = 0; draw < 3; ++draw) {
        const auto spec = test::randomSpec(mesh, topology, {q, cones, false, false}, random);
        if (!spec) continue;
        const auto s = solvedOf(shape.name, mesh, *spec);
        if (!s || !(s->relativeEnergy < 1e-12)) continue;  // softened: the theorem is silent
        ++harmonic;
        if (!hypothesesHold(*s)) continue;
        ++applies;
        EXPECT_EQ(s->certificate.orientation.positive, mesh.faceCount()) << shape.name;
        EXPECT_TRUE(s->certificate.isCertified) << shape.name << " q=" << q;
      }
    }
  }
  EXPECT_GT(harmonic, 10);
  EXPECT_GT(applies, 10);
}

/// What parametrize() gives without any option, for cones that it chose itself.
Result<Parametrization> defaultMap(const TriMesh& mesh, HolonomySpec& spec) {
  const Result<CompleteSpec> cones = suggestCones(mesh, SuggestOptions{});
  if (!cones) return cones.error();
  spec = toSpec(*cones);
  return parametrize(mesh, spec, {});
}

TEST(Theorem61, AppliesToDefaultMaps) {
  for (const test::Shape& shape :
       {test::jittered(test::icosphere(8), 0.03), test::disk(6),
        test::jittered(test::puncturedTorus(20, 14), 0.02),
        test::jittered(test::doubleTorus(4), 0.02), test::cube(4), test::torus(24, 12),
        test::annulus(620, 2), test::withoutFaces(test::icosphere(6), {0, 200})}) {
    const TriMesh mesh = shape.mesh();
    HolonomySpec spec;
    const Result<Parametrization> run = defaultMap(mesh, spec);
    ASSERT_TRUE(run) << shape.name << ": " << run.error().message;
    ASSERT_TRUE(run->isCertified) << shape.name;
    std::vector<VertexId> cones;
    for (const ConePoint& cone : run->spec.cones) cones.push_back(cone.vertex);
    const bool isTorus = cones.empty() && computeTopology(mesh).loops.empty();
    const HarmonicFacts harmonic =
        measureHarmonicity(mesh, computeGeometry(mesh), run->map, run->spec.q, cones);
    EXPECT_GT(harmonic.rows, 0) << shape.name;
    EXPECT_LE(harmonic.largestResidual, 1e-9) << shape.name;
    const Certificate& c = run->certificate;
    EXPECT_EQ(c.orientation.constrainedPositive, c.orientation.constrained) << shape.name;
    EXPECT_TRUE(c.angles.wrong.empty()) << shape.name;
    if (isTorus) {
      EXPECT_EQ(harmonic.weights, WeightKind::kCotangent) << "others collapse it";
    }
  }
}

Solved goodMap() {
  HolonomySpec spec;
  spec.cones = {{VertexId(0), 3}};
  return std::move(*solvedOf("disk", test::disk(4).mesh(), spec));
}

bool breaks(const Solved& s, const UvMap& map, Rule rule) {
  const Certificate c = certify(s.surface.mesh, s.surface.field.spec, map);
  EXPECT_FALSE(c.isCertified);
  for (const Reason& reason : c.reasons)
    if (reason.rule == rule) return true;
  return false;
}

TEST(Theorem61, TheGoodMapIsCertified) { EXPECT_TRUE(goodMap().certificate.isCertified); }

TEST(Theorem61, AFlippedConeTriangleIsCaught) {
  const Solved s = goodMap();
  UvMap map = s.map;
  // A neighbour of the cone pushed across the opposite edge of one of the cone's triangles.
  const HalfedgeId h = s.surface.mesh.outgoing(VertexId(0));
  const auto& t = map.cornerUv[static_cast<std::size_t>(TriMesh::face(h).i)];
  const auto slot = static_cast<std::size_t>(h.i % 3);
  Vec2& a = map.uv[static_cast<std::size_t>(t[(slot + 1) % 3])];
  const Vec2 b = map.uv[static_cast<std::size_t>(t[(slot + 2) % 3])];
  const Vec2 c = map.uv[static_cast<std::size_t>(t[slot])];
  a = {2 * b[0] - a[0] + 0.1 * (c[0] - b[0]), 2 * b[1] - a[1] + 0.1 * (c[1] - b[1])};
  EXPECT_TRUE(breaks(s, map, Rule::kOrientation));
}

TEST(Theorem61, AMirroredMapIsCaughtEverywhere) {
  const Solved s = goodMap();
  UvMap map = s.map;
  for (Vec2& uv : map.uv) uv[0] = -uv[0];
  EXPECT_TRUE(breaks(s, map, Rule::kOrientation));
  EXPECT_EQ(certify(s.surface.mesh, s.surface.field.spec, map).orientation.negative,
            s.surface.mesh.faceCount());
}

TEST(Theorem61, AnotherConeAngleOrTurningIsCaught) {
  // The same surface with the cone elsewhere: a fine map of another prescription.
  const Solved s = goodMap();
  HolonomySpec other;
  other.cones = {{VertexId(7), 3}};
  const auto wrong = solvedOf("other", s.surface.mesh, other);
  ASSERT_TRUE(wrong);
  ASSERT_TRUE(wrong->certificate.isCertified);
  EXPECT_TRUE(breaks(s, wrong->map, Rule::kConeAngle));
  HolonomySpec flat;
  const auto none = solvedOf("flat", s.surface.mesh, flat);
  ASSERT_TRUE(none);
  EXPECT_TRUE(breaks(s, none->map, Rule::kConeAngle));
  EXPECT_TRUE(breaks(s, none->map, Rule::kTurning));
}

TEST(Theorem61, ASeamThatIsNoRotationOfItsTwinIsCaught) {
  const Solved s = goodMap();
  UvMap map = s.map;
  for (std::size_t c = 0; c < map.uv.size(); ++c)  // one copy of one seam vertex moves alone
    if (s.surface.cut.parent[CutVertexId(static_cast<int>(c))] != VertexId(0) &&
        s.surface.seamDegree(s.surface.cut.parent[CutVertexId(static_cast<int>(c))]) == 2) {
      // Edges there are shorter than 1, and may be off by 1e-6 of their own length.
      map.uv[c][0] += 2e-6;
      break;
    }
  EXPECT_TRUE(breaks(s, map, Rule::kSeam));
}

TEST(Theorem61, WithoutHarmonicityFlipsInsideAreCaught) {
  // All hypotheses on cone and boundary triangles hold, only L z = 0 does not: one inner vertex is
  // pushed out of its star. The theorem does not apply, and inspection sees it.
  const Solved s = goodMap();
  const TriMesh& mesh = s.surface.mesh;
  for (VertexId v : mesh.vertices()) {
    bool isInner = !s.surface.isCone(v) && s.surface.seamDegree(v) == 0;
    for (HalfedgeId h : outgoingHalfedges(mesh, v))
      for (VertexId u : mesh.corners(TriMesh::face(h)))
        isInner &= !mesh.isBoundary(u) && !s.surface.isCone(u);
    if (!isInner) continue;
    UvMap map = s.map;
    const auto copyOf = [&](HalfedgeId h) {
      return static_cast<std::size_t>(s.surface.cut.copy[h].i);
    };
    const HalfedgeId h = mesh.outgoing(v);
    const Vec2 from = map.uv[copyOf(h)], to = map.uv[copyOf(TriMesh::next(h))];
    map.uv[copyOf(h)] = {from[0] + 1.5 * (to[0] - from[0]), from[1] + 1.5 * (to[1] - from[1])};
    const Certificate c = certify(mesh, s.surface.field.spec, map);
    EXPECT_EQ(c.orientation.constrainedPositive, c.orientation.constrained);
    EXPECT_TRUE(breaks(s, map, Rule::kOrientation));
    return;
  }
  FAIL() << "no inner vertex";
}

}  // namespace
}  // namespace hgp
