#include "hgp/field/prepared_surface.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "hgp/cones/choose_cones.h"
#include "support/shapes.h"

namespace hgp {
namespace {

bool areEqual(const PrescribedField& a, const PrescribedField& b) {
  return a.field.angle.raw() == b.field.angle.raw() &&
         a.field.matching.raw() == b.field.matching.raw() && a.u.raw() == b.u.raw();
}

TEST(PreparedSurface, KeepsItsFieldForTheSameConesInAnyOrder) {
  const TriMesh mesh = test::torus(24, 12).mesh();
  PreparedSurface surface(mesh);
  HolonomySpec spec;
  spec.cones = {{VertexId(5), 3}, {VertexId(90), 5}, {VertexId(150), 3}, {VertexId(201), 5}};
  spec.handles = {0, 0};
  const Result<PrescribedField> field = surface.field(spec);
  ASSERT_TRUE(field);
  surface.releaseConnection();  // made again if anything is computed
  std::reverse(spec.cones.begin(), spec.cones.end());
  const Result<PrescribedField> kept = surface.field(spec);
  ASSERT_TRUE(kept);
  EXPECT_FALSE(surface.hasConnection());
  EXPECT_TRUE(areEqual(*field, *kept));
  std::swap(spec.cones[0].k, spec.cones[1].k);  // other cones at the same vertices
  const Result<PrescribedField> other = surface.field(spec);
  ASSERT_TRUE(other);
  EXPECT_TRUE(surface.hasConnection());
  EXPECT_FALSE(areEqual(*field, *other));
}

TEST(PreparedSurface, SearchesForTooFewTrianglesOncePerPrescription) {
  const TriMesh mesh = test::jittered(test::icosphere(6), 0.05).mesh();
  PreparedSurface surface(mesh);
  SuggestOptions options;
  const Result<HolonomySpec> spec = chooseCones(surface, options);
  ASSERT_TRUE(spec);
  const int searches = surface.shortages().searches();
  EXPECT_EQ(searches, 1);
  ASSERT_TRUE(checkPrescription(mesh, surface.topology(), *spec, &surface.shortages()));
  EXPECT_EQ(surface.shortages().searches(), searches);
}

TEST(PreparedSurface, KeptShortagesAreThoseOfASearch) {
  const TriMesh mesh = test::disk(8).mesh();
  PreparedSurface surface(mesh);
  PerVertex<int> k(static_cast<std::size_t>(mesh.vertexCount()), 4);
  VertexId a;
  for (VertexId v : mesh.vertices())
    if (!a.isValid() && mesh.valence(v) == 6 && !mesh.isBoundary(mesh.head(mesh.outgoing(v))) &&
        mesh.valence(mesh.head(mesh.outgoing(v))) == 6)
      a = v;
  const VertexId b = mesh.head(mesh.outgoing(a));
  AngleShortageMemo& memo = surface.shortages();
  k[a] = k[b] = 10;
  for (int repeat = 0; repeat < 2; ++repeat) EXPECT_TRUE(memo.find(mesh, 4, k));
  k[b] = 9;
  for (int repeat = 0; repeat < 2; ++repeat) EXPECT_FALSE(memo.find(mesh, 4, k));
  k[b] = 10;
  EXPECT_TRUE(memo.find(mesh, 4, k));
  EXPECT_FALSE(memo.find(mesh, 5, k)) << "of another order";
  EXPECT_EQ(memo.searches(), 4);
}

}  // namespace
}  // namespace hgp
