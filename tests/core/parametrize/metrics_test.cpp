#include <gtest/gtest.h>

#include <array>

#include "core/parametrize/stretched.h"
#include "hgp/mesh/geometry.h"
#include "hgp/parametrize/parametrize.h"
#include "support/shapes.h"

namespace hgp {
namespace {

using test::evenedRounds;
using test::expectMappedWithEvenedLengths;
using test::manyCones;
using test::stretched;

/// Solved once for all tests.
const Result<Parametrization>& mapOfThinTriangles() {
  static const Result<Parametrization> solved = [] {
    const TriMesh mesh = stretched(1e5);
    return parametrize(mesh, manyCones(mesh), {});
  }();
  return solved;
}

TEST(Metrics, VeryThinTrianglesAreMappedWithEvenedLengths) {
  const TriMesh mesh = stretched(1e5);
  const Result<Parametrization>& p = mapOfThinTriangles();
  ASSERT_TRUE(p) << p.error().message;
  expectMappedWithEvenedLengths(mesh, *p);
}

TEST(Metrics, TheMapHasTheAreaOfTheSurfaceItself) {
  const TriMesh mesh = stretched(1e5);
  const Result<Parametrization>& p = mapOfThinTriangles();
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
  const TriMesh mesh = stretched(1e5);
  ParametrizeOptions options;
  options.method = Method::kHarmonic;
  const Result<Parametrization> p = parametrize(mesh, manyCones(mesh), options);
  ASSERT_TRUE(p) << p.error().message;
  EXPECT_EQ(evenedRounds(*p), 0);
}

}  // namespace
}  // namespace hgp
