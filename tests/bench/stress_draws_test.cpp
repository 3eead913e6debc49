#include <gtest/gtest.h>

#include <map>
#include <numeric>

#include "degrade.h"
#include "draw.h"
#include "integer_sums.h"
#include "support/shapes.h"
#include "surfaces.h"

namespace hgp::stress {
namespace {

TEST(IntegerSums, EveryVectorOfTheSumIsEquallyLikely) {
  const std::vector<IntegerRange> ranges = {{-1, 1, 0}, {-1, 1, 0}, {-1, 3, {}}};
  std::map<std::vector<int>, int> seen;
  Random random("uniform");
  const int draws = 8000;
  for (int n = 0; n < draws; ++n) {
    const auto x = drawWithSum(ranges, 1, random);
    ASSERT_TRUE(x);
    EXPECT_EQ(std::accumulate(x->begin(), x->end(), 0), 1);
    ++seen[*x];
  }
  // (1,1,−1), (1,−1,1), (−1,1,1), (−1,−1,3).
  ASSERT_EQ(seen.size(), 4u);
  for (const auto& [x, count] : seen) EXPECT_NEAR(count, draws / 4, 5 * 39);  // 5 σ
}

TEST(IntegerSums, NothingWhereNoVectorHasTheSum) {
  Random random("none");
  EXPECT_FALSE(drawWithSum({{-1, 1, 0}, {-1, 1, 0}}, 1, random));
  EXPECT_FALSE(drawWithSum({{0, 3, {}}, {2, 1, {}}}, 3, random));
}

TEST(StressDraws, PassTheCheckAndBelongToTheirFamily) {
  int drawn = 0;
  for (const test::Shape& shape : {test::icosphere(5), test::pretzel(3, 3), test::annulus(24, 8),
                                   test::puncturedTorus(14, 18), test::torus(14, 18)}) {
    const TriMesh mesh = shape.mesh();
    const Topology topology = computeTopology(mesh);
    for (const Family family : kFamilies) {
      Random random(shape.name + familyName(family));
      for (int n = 0; n < 10; ++n) {
        const auto spec = draw(mesh, topology, family, random);
        if (!spec) continue;
        ++drawn;
        EXPECT_TRUE(checkPrescription(mesh, topology, *spec)) << shape.name << familyName(family);
        EXPECT_GE(spec->cones.size(), 3u);
        int largest = 0;
        for (const ConePoint& c : spec->cones) largest = std::max(largest, c.k);
        if (family == Family::kBig) {
          EXPECT_GE(largest, 2 * spec->q);
        }
        if (family == Family::kHandles) {
          EXPECT_EQ(spec->handles.size(), 2u * static_cast<unsigned>(topology.genus));
        }
      }
    }
  }
  EXPECT_GE(drawn, 180);  // of 220 that apply
}

TEST(StressDraws, TheSameNameGivesTheSameDraw) {
  const TriMesh mesh = test::icosphere(4).mesh();
  const Topology topology = computeTopology(mesh);
  Random one("7/random/x/0"), same("7/random/x/0"), other("7/random/x/1");
  const auto a = draw(mesh, topology, Family::kRandom, one);
  const auto b = draw(mesh, topology, Family::kRandom, same);
  const auto c = draw(mesh, topology, Family::kRandom, other);
  ASSERT_TRUE(a && b && c);
  const auto text = [](const HolonomySpec& s) {
    std::string t = std::to_string(s.q);
    for (const ConePoint& p : s.cones)
      t += " " + std::to_string(p.vertex.i) + ":" + std::to_string(p.k);
    return t;
  };
  EXPECT_EQ(text(*a), text(*b));
  EXPECT_NE(text(*a), text(*c));
}

TEST(GeneratedSurfaces, HaveTheAskedGenusAndHoles) {
  int asked = 0, right = 0;
  for (int genus = 0; genus <= 4; ++genus) {
    for (int holes = 0; holes <= 2; holes += 2) {
      const MeshData data = randomSurface("test " + std::to_string(genus), genus, holes);
      const auto mesh = buildTriMesh(data);
      ASSERT_TRUE(mesh);
      const Topology topology = computeTopology(*mesh);
      EXPECT_EQ(topology.componentCount, 1);
      ++asked;
      right += topology.genus == genus;
      EXPECT_GE(topology.loops.size(), holes > 0 ? 1u : 0u);
    }
  }
  EXPECT_GE(right, asked - 2);  // a hole may swallow a handle
}

TEST(Harms, LeaveAnOrientedManifoldOfTheSameTopology) {
  for (const test::Shape& shape :
       {test::jittered(test::pretzel(2, 4), 0.05), test::jittered(test::disk(12), 0.1)}) {
    const Topology before = computeTopology(shape.mesh());
    for (const Harm& harm : harms()) {
      Random random(harm.kind + shape.name);
      const auto data = degraded(shape.data, harm, random);
      if (!data) {
        EXPECT_TRUE(harm.kind == "needles" && before.loops.empty());
        continue;
      }
      const auto mesh = buildTriMesh(*data);
      ASSERT_TRUE(mesh) << harm.kind << harm.level << ": " << mesh.error().message;
      const Topology after = computeTopology(*mesh);
      EXPECT_EQ(after.genus, before.genus) << harm.kind << harm.level;
      EXPECT_EQ(after.loops.size(), before.loops.size());
      if (harm.kind == "decimation" && harm.level == 0.5) {
        EXPECT_NEAR(mesh->faceCount(), 0.5 * shape.mesh().faceCount(), 4);
      }
      if (harm.kind != "decimation" && harm.kind != "slivers") {
        EXPECT_NE(data->positions, shape.data.positions) << harm.kind;
      }
    }
  }
}

}  // namespace
}  // namespace hgp::stress
