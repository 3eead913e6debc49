#include "hgp/mesh/holonomy_spec.h"

#include <gtest/gtest.h>

#include <random>
#include <regex>

#include "support/notes.h"
#include "support/shapes.h"

namespace hgp {
namespace {

using Options = std::vector<std::optional<int>>;

struct Surface {
  TriMesh mesh;
  Topology topology;
  std::vector<VertexId> interior;  ///< highest valence first
};

Surface surfaceOf(const test::Shape& shape) {
  Surface s{shape.mesh(), {}, {}};
  s.topology = computeTopology(s.mesh);
  for (VertexId v : s.mesh.vertices())
    if (!s.mesh.isBoundary(v) && !s.mesh.isIsolated(v)) s.interior.push_back(v);
  std::stable_sort(s.interior.begin(), s.interior.end(),
                   [&](VertexId a, VertexId b) { return s.mesh.valence(a) > s.mesh.valence(b); });
  return s;
}

/// Cones of the given k at different interior vertices.
HolonomySpec specOf(const Surface& s, int q, const std::vector<int>& k) {
  HolonomySpec spec;
  spec.q = q;
  for (std::size_t n = 0; n < k.size(); ++n) spec.cones.push_back({s.interior.at(n), k[n]});
  return spec;
}

Result<BudgetReport> check(const Surface& s, const HolonomySpec& spec) {
  return checkPrescription(s.mesh, s.topology, spec);
}

std::string refusal(const Surface& s, const HolonomySpec& spec) {
  const Result<BudgetReport> report = check(s, spec);
  if (report) return "";
  EXPECT_EQ(report.error().code, ErrorCode::kPrescription);
  EXPECT_EQ(report.error().stage, "prescription");
  return report.error().message;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::vector<int> times(int n, int k) { return std::vector<int>(static_cast<std::size_t>(n), k); }

TEST(HolonomySpec, GaussBonnetReportsTheDifferenceAndHowToBalanceIt) {
  const Surface sphere = surfaceOf(test::icosphere(4));
  EXPECT_EQ(refusal(sphere, specOf(sphere, 4, times(8, 3))), "");
  EXPECT_EQ(refusal(sphere, specOf(sphere, 4, times(7, 3))),
            "Gauss–Bonnet (Lemma 6.2): Σ = 7, need 8 (q=4, g=0, m=0); 1 missing: lower the k of "
            "cones by 1 in total (a new cone of k=3).");
  EXPECT_EQ(refusal(sphere, specOf(sphere, 4, times(10, 3))),
            "Gauss–Bonnet (Lemma 6.2): Σ = 10, need 8 (q=4, g=0, m=0); 2 too many: raise the k of "
            "cones by 2 in total (a new cone of k=6).");
  EXPECT_TRUE(contains(refusal(sphere, specOf(sphere, 4, {})), "8 missing"));
}

/// The k of the cones that a refusal advises: "2 new cones of k=6 and a new cone of k=5".
std::vector<int> advisedCones(const std::string& refusal) {
  std::vector<int> all;
  const std::regex one(R"((\d+|a) new cones? of k=(\d+))");
  for (std::sregex_iterator it(refusal.begin(), refusal.end(), one), end; it != end; ++it)
    for (int n = (*it)[1] == "a" ? 1 : std::stoi((*it)[1]); n > 0; --n)
      all.push_back(std::stoi((*it)[2]));
  return all;
}

TEST(HolonomySpec, AdvisedConesBalanceAndFitOnVerticesOfSixTriangles) {
  for (const test::Shape& shape : {test::icosphere(4), test::pretzel(2, 4), test::torus(16, 8)}) {
    const Surface s = surfaceOf(shape);
    for (int q : {1, 2, 3, 4, 5, 6, 7}) {
      for (int lowered = q > 1 ? 1 : 0; lowered < 12; ++lowered) {
        const std::vector<int> given = times(lowered, q - 1);
        const std::vector<int> advised = advisedCones(refusal(s, specOf(s, q, given)));
        if (advised.empty()) continue;  // balanced, or q = 1 has no cones of positive curvature
        long long sum = 0;
        for (const int k : given) sum += q - k;
        for (const int k : advised) {
          sum += q - k;
          EXPECT_LT(2 * k, q * 6) << shape.name << q;
          EXPECT_GE(k, 1) << shape.name << q;
        }
        EXPECT_EQ(sum, q * shape.eulerCharacteristic()) << shape.name << q << ' ' << lowered;
      }
    }
  }
}

TEST(HolonomySpec, BudgetHoldsForEveryShapeWhenOneConeTakesTheRest) {
  for (const test::Shape& shape : test::closed()) {
    const Surface s = surfaceOf(shape);
    for (int q : {2, 3, 4, 6, 7}) {
      const int rest = q - q * shape.eulerCharacteristic();  // one cone's k
      const bool isAllowed = rest >= 1 && 2 * rest < q * s.mesh.valence(s.interior[0]) && rest != q;
      if (isAllowed) {
        EXPECT_EQ(refusal(s, specOf(s, q, {rest})), "") << shape.name << q;
        EXPECT_TRUE(contains(refusal(s, specOf(s, q, {rest - 1})), "1 too many")) << shape.name;
      }
    }
  }
}

TEST(HolonomySpec, OpenLoopsTakeWhatIsMissingWithinTheirBounds) {
  const Surface disk = surfaceOf(test::disk(3));
  const Result<BudgetReport> report = check(disk, specOf(disk, 4, {3, 3}));
  ASSERT_TRUE(report);
  EXPECT_EQ(report->have, 2);
  EXPECT_EQ(report->need, 4);
  EXPECT_EQ(report->openLoops, 1);
  HolonomySpec spec = specOf(disk, 4, {3, 3});
  spec.turning = {2};
  ASSERT_TRUE(check(disk, spec));
  EXPECT_EQ(check(disk, spec)->openLoops, 0);
  spec.turning = {3};
  EXPECT_TRUE(contains(refusal(disk, spec), "1 too many"));
  EXPECT_TRUE(contains(refusal(disk, spec), "lower turning indices"));
  const Surface triangle = surfaceOf(test::triangle());
  spec = specOf(triangle, 4, {});
  EXPECT_EQ(refusal(triangle, spec), "");
}

TEST(HolonomySpec, OpenLoopsThatCannotBalanceAreRefused) {
  // The only inner vertex of a hexagon may have k up to 11; the boundary then must turn by 11, while
  // six vertices can turn by less than 12 and, with two triangles each, by more than −12.
  const Surface hexagon = surfaceOf(test::disk(1));
  EXPECT_EQ(refusal(hexagon, specOf(hexagon, 4, {11})), "");
  const Surface grid = surfaceOf(test::grid(2, 2));
  const TurningRange range = turningRange(grid.mesh, grid.topology.loops[0], 4);
  EXPECT_EQ(range.highest, 15);
  const Surface shape = surfaceOf(test::withoutFaces(test::icosphere(3), {0}));
  // Three boundary vertices turn by less than 6 quarter turns; cones ask for more.
  const std::string text = refusal(shape, specOf(shape, 4, {8, 8}));
  EXPECT_TRUE(contains(text, "open boundary loop")) << text;
}

TEST(HolonomySpec, TurningRangeIsExactlyTheOpenInterval) {
  for (const test::Shape& shape : test::withBoundary()) {
    const Surface s = surfaceOf(shape);
    for (const BoundaryLoop& loop : s.topology.loops)
      for (int q = 1; q <= 8; ++q) {
        long long slack = 0;
        for (HalfedgeId h : loop.halfedges) slack += 1 - s.mesh.valence(s.mesh.tail(h));
        const auto n = static_cast<long long>(loop.halfedges.size());
        const TurningRange range = turningRange(s.mesh, loop, q);
        const auto isInside = [&](long long l) { return q * slack < 2 * l && 2 * l < q * n; };
        EXPECT_TRUE(isInside(range.lowest) && isInside(range.highest)) << shape.name;
        EXPECT_FALSE(isInside(range.lowest - 1) || isInside(range.highest + 1)) << shape.name;
      }
  }
}

TEST(HolonomySpec, RefusesCones) {
  const Surface s = surfaceOf(test::grid(4, 4));
  HolonomySpec spec = specOf(s, 4, {0});
  EXPECT_TRUE(contains(refusal(s, spec), "k < 1"));
  spec = specOf(s, 4, {2 * s.mesh.valence(s.interior[0])});
  EXPECT_TRUE(contains(refusal(s, spec), "2k ≥ q·valence"));
  spec.cones[0].k -= 1;
  EXPECT_EQ(refusal(s, spec), "");
  spec = specOf(s, 4, {3, 3});
  spec.cones[1].vertex = spec.cones[0].vertex;
  EXPECT_TRUE(contains(refusal(s, spec), "given twice"));
  for (int v : {-1, s.mesh.vertexCount()}) {
    spec.cones = {{VertexId(v), 3}};
    EXPECT_TRUE(contains(refusal(s, spec), "does not exist"));
  }
  spec.cones = {{VertexId(0), 3}};
  EXPECT_TRUE(contains(refusal(s, spec), "on the boundary"));
  MeshData data = test::cube().data;
  data.positions.push_back({5, 5, 5});
  Surface isolated{test::meshOf(data), {}, {}};
  isolated.topology = computeTopology(isolated.mesh);
  spec.cones = {{VertexId(8), 3}};
  EXPECT_TRUE(contains(refusal(isolated, spec), "without faces"));
}

TEST(HolonomySpec, RefusalsPointAtTheConesTheyMean) {
  const Surface s = surfaceOf(test::grid(4, 4));
  const Result<BudgetReport> report = check(s, specOf(s, 4, {0, 4, -3}));
  ASSERT_FALSE(report);
  ASSERT_EQ(report.error().where.size(), 2u);
  EXPECT_EQ(report.error().where[0].id, s.interior[0].i);
  EXPECT_EQ(report.error().where[1].id, s.interior[2].i);
}

TEST(HolonomySpec, RefusesWrongSizesAndOrders) {
  const Surface torus = surfaceOf(test::torus(6, 5)), disk = surfaceOf(test::disk(2));
  for (int q : {-4, 0, 65}) EXPECT_TRUE(contains(refusal(disk, specOf(disk, q, {})), "order"));
  for (int q : {1, 64}) EXPECT_EQ(refusal(disk, specOf(disk, q, {})), "");
  HolonomySpec spec = specOf(disk, 4, {});
  spec.turning = {4, 4};
  EXPECT_TRUE(contains(refusal(disk, spec), "2 turning indices"));
  spec = specOf(torus, 4, {});
  spec.handles = {0};
  EXPECT_TRUE(contains(refusal(torus, spec), "1 handle rotations"));
  spec.handles = {0, std::nullopt};
  EXPECT_EQ(refusal(torus, spec), "");
}

TEST(HolonomySpec, RefusesTurningOutOfReach) {
  const Surface triangle = surfaceOf(test::triangle());
  HolonomySpec spec = specOf(triangle, 4, {});
  for (int l : {0, -4, 6, 100}) {
    spec.turning = {l};
    EXPECT_TRUE(contains(refusal(triangle, spec), "out of range")) << l;
  }
  spec.turning = {4};
  EXPECT_EQ(refusal(triangle, spec), "");
}

TEST(HolonomySpec, RefusesASphereOfOrderOne) {
  const Surface sphere = surfaceOf(test::icosphere(2)), disk = surfaceOf(test::disk(2));
  EXPECT_TRUE(contains(refusal(sphere, specOf(sphere, 1, {})), "q = 1"));
  EXPECT_EQ(refusal(disk, specOf(disk, 1, {})), "");
}

TEST(HolonomySpec, RefusesTheTwoConeTorus) {
  const Surface torus = surfaceOf(test::torus(8, 7)),
                punctured = surfaceOf(test::puncturedTorus(8, 7));
  for (int q : {2, 3, 4, 5, 6, 12}) {
    EXPECT_TRUE(contains(refusal(torus, specOf(torus, q, {q - 1, q + 1})), "exactly two cones"))
        << q;
    EXPECT_TRUE(contains(refusal(torus, specOf(torus, q, {q + 1, q, q - 1})), "exactly two cones"));
    EXPECT_EQ(refusal(torus, specOf(torus, q, {q - 1, q - 1, q + 2})), "");
    EXPECT_EQ(refusal(punctured, specOf(punctured, q, {q - 1, q + 1})), "");
  }
  // q = 8 with {6, 10} is q = 4 with {3, 5} unless a handle is odd.
  HolonomySpec spec = specOf(torus, 8, {6, 10});
  ASSERT_TRUE(check(torus, spec));
  EXPECT_EQ(test::codesOf(check(torus, spec)->warnings), test::Codes{"budget-two-cones"});
  spec.handles = {2, 4};
  EXPECT_TRUE(contains(refusal(torus, spec), "common divisor 2 to q=4"));
  spec.handles = {2, 3};
  EXPECT_EQ(refusal(torus, spec), "");
  EXPECT_TRUE(check(torus, spec)->warnings.empty());
}

TEST(HolonomySpec, RefusesRotationOnAConeFreeTorus) {
  const Surface torus = surfaceOf(test::torus(6, 5));
  HolonomySpec spec = specOf(torus, 4, {4});  // k = q is no cone
  for (const auto& handles : {Options{0, 1}, Options{std::nullopt, 2}, Options{-1, 0}}) {
    spec.handles = handles;
    EXPECT_TRUE(contains(refusal(torus, spec), "must be 0"));
  }
  spec.handles = {0, 8};
  EXPECT_EQ(refusal(torus, spec), "");
}

TEST(HolonomySpec, WarnsOfEmptyStrataOfGenusTwo) {
  const Surface s = surfaceOf(test::doubleTorus(4));
  const auto warnings = [&](const HolonomySpec& spec) {
    const Result<BudgetReport> report = check(s, spec);
    EXPECT_TRUE(report) << report.error().message;
    return report ? report->warnings : Notes{};
  };
  const auto known = [&](const HolonomySpec& spec) {
    const Notes found = warnings(spec);
    return findNote(found, "budget-empty-stratum") || findNote(found, "budget-one-cone");
  };
  EXPECT_TRUE(known(specOf(s, 2, {3, 5})));
  EXPECT_TRUE(known(specOf(s, 2, {5, 3})));
  EXPECT_FALSE(known(specOf(s, 2, {4, 4})));
  EXPECT_FALSE(known(specOf(s, 2, {3, 3, 4})));
  HolonomySpec spec = specOf(s, 2, {5, 3});
  spec.handles = {0, 0, 0, 0};
  EXPECT_TRUE(known(spec));
  // {6} of q = 2 is a translation surface when the handles are trivial, and nothing otherwise.
  ASSERT_GT(s.mesh.valence(s.interior[0]), 6);
  spec = specOf(s, 2, {6});
  EXPECT_TRUE(known(spec));
  spec.handles = {0, 2, 0, 0};
  EXPECT_FALSE(known(spec));
  spec.handles = {0, 1, 0, 0};
  EXPECT_TRUE(known(spec));
}

TEST(HolonomySpec, WarnsOfVerticesWithTooFewTriangles) {
  const Surface s = surfaceOf(test::disk(4));
  ASSERT_EQ(s.mesh.valence(s.interior[0]), 6);
  // 2π·7/4 over six triangles is 1.83 rad each, 2π·8/4 is 2.09.
  EXPECT_TRUE(check(s, specOf(s, 4, {7}))->warnings.empty());
  const auto warnings = check(s, specOf(s, 4, {8}))->warnings;
  ASSERT_EQ(test::codesOf(warnings), test::Codes{"budget-few-triangles"});
  EXPECT_EQ(warnings[0].where, (std::vector<Where>{{Where::Kind::kVertex, s.interior[0].i}}));
}

TEST(HolonomySpec, CompleteSpecsBecomeSpecsWithNothingOpen) {
  const CompleteSpec complete{6,      {{VertexId(3), 5}}, {2, -1},
                              {0, 5}, {EdgeId(7)},        {{VertexId(4), 1}}};
  const HolonomySpec spec = toSpec(complete);
  EXPECT_EQ(spec.q, 6);
  EXPECT_EQ(spec.cones.size(), 1u);
  EXPECT_EQ(spec.features, complete.features);
  ASSERT_EQ(spec.corners.size(), 1u);
  EXPECT_EQ(spec.corners[0].vertex, VertexId(4));
  EXPECT_EQ(spec.turning, (Options{2, -1}));
  EXPECT_EQ(spec.handles, (Options{0, 5}));
}

}  // namespace
}  // namespace hgp
