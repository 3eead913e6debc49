// Cones that were chosen may be replaced by those that a map has.  Laws: the map fulfils the new prescription, which
// differs where the note says; prescribed cones, and those that have a map without untangling, stay.
#include <gtest/gtest.h>

#include <map>
#include <optional>

#include "core/parametrize/stretched.h"
#include "hgp/parametrize/parametrize.h"
#include "support/shapes.h"

namespace hgp {
namespace {

std::map<VertexId, int> kOf(const CompleteSpec& spec) {
  std::map<VertexId, int> k;
  for (const ConePoint& cone : spec.cones) k[cone.vertex] = cone.k;
  return k;
}

/// Vertices whose angle differs.
std::size_t countOther(const CompleteSpec& a, const CompleteSpec& b) {
  std::map<VertexId, int> ka = kOf(a), kb = kOf(b);
  for (const ConePoint& cone : a.cones) kb.try_emplace(cone.vertex, b.q);
  for (const ConePoint& cone : b.cones) ka.try_emplace(cone.vertex, a.q);
  std::size_t count = 0;
  for (const auto& [v, k] : ka) count += kb.at(v) != k;
  return count;
}

int sumOf(const CompleteSpec& spec) {
  int sum = 0;
  for (const ConePoint& cone : spec.cones) sum += spec.q - cone.k;
  return sum;
}

/// The same surface and cones, mapped with and without leave to change them.
struct Pair {
  Parametrization asked, free;
};

/// One for which only other cones have a map. Which these are hangs on the last bits, and so on the processor: nearly all do.
std::optional<Pair> findUnmapped(double& stretch) {
  for (const double factor : {1000.0, 400.0, 200.0, 150.0, 100.0}) {
    const TriMesh mesh = test::stretched(factor, 2);
    ParametrizeOptions options;
    options.maxRounds = 6;
    options.areConesFree = true;
    Result<Parametrization> free = parametrize(mesh, test::manyCones(mesh), options);
    if (!free || !findNote(free->notes, "map-own-cones")) continue;
    options.areConesFree = false;
    Result<Parametrization> asked = parametrize(mesh, test::manyCones(mesh), options);
    if (!asked || asked->isCertified) continue;
    stretch = factor;
    return Pair{std::move(*asked), std::move(*free)};
  }
  return {};
}

TEST(OwnCones, AreThoseOfAMapWithoutFoldsWhereNoMapHasTheChosenOnes) {
  double stretch = 0;
  const std::optional<Pair> pair = findUnmapped(stretch);
  ASSERT_TRUE(pair);
  const TriMesh mesh = test::stretched(stretch, 2);
  const Parametrization &asked = pair->asked, &free = pair->free;
  EXPECT_TRUE(free.isCertified);
  EXPECT_LE(free.rounds.size(), asked.rounds.size());

  EXPECT_TRUE(certify(mesh, toSpec(free.spec), free.map).isCertified);
  EXPECT_FALSE(certify(mesh, toSpec(asked.spec), free.map).isCertified);
  EXPECT_EQ(free.spec.handles, asked.spec.handles);
  EXPECT_EQ(sumOf(free.spec), 0);  // of a torus
  const Note* note = findNote(free.notes, "map-own-cones");
  ASSERT_NE(note, nullptr);
  EXPECT_EQ(*note, Note("map-own-cones", {{"vertices", countOther(asked.spec, free.spec)}}));
  EXPECT_GT(countOther(asked.spec, free.spec), 0u);
}

TEST(OwnCones, AreNotLookedForWhereTheChosenOnesHaveAMap) {
  const TriMesh mesh = test::pretzel(1, 3).mesh();
  ParametrizeOptions options;
  options.areConesFree = true;
  const Result<Parametrization> free = parametrize(mesh, test::manyCones(mesh), options);
  ASSERT_TRUE(free);
  EXPECT_TRUE(free->isCertified);
  EXPECT_EQ(free->spec.cones.size(), test::manyCones(mesh).cones.size());
  EXPECT_EQ(findNote(free->notes, "map-own-cones"), nullptr);
}

}  // namespace
}  // namespace hgp
