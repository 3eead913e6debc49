#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>

#include "hgp/mesh/geometry.h"
#include "hgp/parametrize/parametrize.h"
#include "support/shapes.h"

namespace hgp {
namespace {

/// A torus of squares; stretched, most of its triangles are very thin.
TriMesh stretched(double factor) {
  test::Shape shape = test::jittered(test::pretzel(1, 4), 0.05);
  for (auto& p : shape.data.positions) p[0] *= factor;
  return shape.mesh();
}

/// Twelve cones of 3π/2 and as many of 5π/2, spread over the vertices.
HolonomySpec manyCones(const TriMesh& mesh) {
  HolonomySpec spec;
  spec.q = 4;
  const int step = mesh.vertexCount() / 24;
  for (int i = 0; i < 24; ++i)
    spec.cones.push_back({VertexId{i * step + i % 5}, i % 2 == 0 ? 5 : 3});
  return spec;
}

/// The map of manyCones on a torus stretched so far; each is solved once for all tests.
const Result<Parametrization>& mapOfStretched(double factor) {
  static std::map<double, Result<Parametrization>> solved;
  auto found = solved.find(factor);
  if (found == solved.end()) {
    const TriMesh mesh = stretched(factor);
    found = solved.emplace(factor, parametrize(mesh, manyCones(mesh), {})).first;
  }
  return found->second;
}

bool isEvened(const Round& round) { return round.method.starts_with("evened lengths: "); }

long long evenedRounds(const Parametrization& p) {
  return std::count_if(p.rounds.begin(), p.rounds.end(), isEvened);
}

TEST(Metrics, VeryThinTrianglesAreMappedWithEvenedLengths) {
  for (const double factor : {200.0, 5000.0}) {
    const TriMesh mesh = stretched(factor);
    const Result<Parametrization>& p = mapOfStretched(factor);
    ASSERT_TRUE(p) << p.error().message;
    ASSERT_TRUE(p->isCertified);
    EXPECT_TRUE(certify(mesh, p->spec, p->map).isCertified);
    EXPECT_GT(evenedRounds(*p), 0);
    EXPECT_TRUE(isEvened(p->rounds.back()));
    EXPECT_LE(p->rounds.size(), 24u);
    ASSERT_FALSE(p->notes.empty());
    EXPECT_NE(p->notes.back().find("evened lengths"), std::string::npos);
  }
}

TEST(Metrics, TheMapHasTheAreaOfTheSurfaceItself) {
  const TriMesh mesh = stretched(200.0);
  const Result<Parametrization>& p = mapOfStretched(200.0);
  ASSERT_TRUE(p && p->isCertified && evenedRounds(*p) > 0);
  const Geometry own = computeGeometry(mesh);
  double mapped = 0.0, asked = 0.0;
  for (FaceId f : mesh.faces()) {
    asked += own.area[f] * own.unit * own.unit;
    const auto& c = p->map.cornerUv[static_cast<std::size_t>(f.i)];
    const auto at = [&](std::size_t k) { return p->map.uv[static_cast<std::size_t>(c[k])]; };
    const auto [a, b, d] = std::array{at(0), at(1), at(2)};
    mapped += 0.5 * ((b[0] - a[0]) * (d[1] - a[1]) - (b[1] - a[1]) * (d[0] - a[0]));
  }
  EXPECT_NEAR(mapped / asked, 1.0, 1e-9);
}

TEST(Metrics, RoundsOfBothAreCountedTogether) {
  const TriMesh mesh = stretched(200.0);
  ParametrizeOptions options;
  options.maxRounds = 9;
  const Result<Parametrization> p = parametrize(mesh, manyCones(mesh), options);
  ASSERT_TRUE(p) << p.error().message;
  EXPECT_LE(p->rounds.size(), 9u);
  EXPECT_LE(evenedRounds(*p), 1);
}

TEST(Metrics, SurfacesWithoutThinTrianglesAreSolvedInTheirOwnMetricAlone) {
  // Two neighbours of six triangles each, ten in all, and angles of 5π each: there is no map, and that is known.
  const TriMesh mesh = stretched(1.0);
  const auto trianglesAt = [&](VertexId v) {
    int count = 0;
    for ([[maybe_unused]] HalfedgeId h : outgoingHalfedges(mesh, v)) ++count;
    return count;
  };
  HolonomySpec spec;
  spec.q = 4;
  for (VertexId v : mesh.vertices()) {
    const VertexId beside = mesh.head(mesh.outgoing(v));
    if (trianglesAt(v) != 6 || trianglesAt(beside) != 6) continue;
    spec.cones = {{v, 10}, {beside, 10}};
    break;
  }
  ASSERT_EQ(spec.cones.size(), 2u);
  for (int i = 0; spec.cones.size() < 8; i += 5) {
    const VertexId v{i};
    if (v != spec.cones[0].vertex && v != spec.cones[1].vertex) spec.cones.push_back({v, 2});
  }
  const Result<Parametrization> p = parametrize(mesh, spec, {});
  ASSERT_TRUE(p) << p.error().message;
  EXPECT_FALSE(p->isCertified);
  EXPECT_EQ(p->rounds.size(), 1u);
  EXPECT_EQ(evenedRounds(*p), 0);
}

TEST(Metrics, AMethodThatIsAskedForByNameIsNotReplaced) {
  const TriMesh mesh = stretched(200.0);
  ParametrizeOptions options;
  options.method = Method::kHarmonic;
  const Result<Parametrization> p = parametrize(mesh, manyCones(mesh), options);
  ASSERT_TRUE(p) << p.error().message;
  EXPECT_EQ(evenedRounds(*p), 0);
}

}  // namespace
}  // namespace hgp
