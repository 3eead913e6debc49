// Untangling along features, and the distances that integers keep.  Laws: from a spoiled start every triangle becomes positive
// while features stay straight and given unknowns what they are; every distance is that of the map, and of three cones or
// corners in a triangle none crosses the line between the others.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "hgp/grid/line_gaps.h"
#include "hgp/optimize/untangle_straight.h"
#include "hgp/parametrize/along/straight_run.h"
#include "support/creases.h"

namespace hgp {
namespace {

/// A certified map along features, as solved.
struct Solved {
  Solved(const test::CreasedShape& shape, PreparedSurface& surface)
      : setup(*prepareStraight(surface, shape.features, HolonomySpec{}, options, times)) {
    std::vector<Round> rounds;
    result = StraightRun(shape.mesh, setup, options, rounds).run()->program;
  }
  ParametrizeOptions options;
  std::vector<StageTime> times;
  StraightSetup setup;
  StraightResult result;
};

int copyOf(const Solved& map, HalfedgeId h) { return map.setup.seamless.cut.copy[h].i; }

double doubleArea(const Solved& map, const std::vector<Complex>& z, FaceId f) {
  const HalfedgeId h = TriMesh::halfedge(f, 0);
  const Complex a = z[at(copyOf(map, h))];
  const Complex b = z[at(copyOf(map, TriMesh::next(h)))] - a;
  const Complex c = z[at(copyOf(map, TriMesh::previous(h)))] - a;
  return b.real() * c.imag() - b.imag() * c.real();
}

int turned(const TriMesh& mesh, const Solved& map, const std::vector<Complex>& z) {
  int count = 0;
  for (const FaceId f : mesh.faces()) count += doubleArea(map, z, f) > 0.0 ? 0 : 1;
  return count;
}

TEST(AlongUntangling, ASpoiledStartBecomesPositiveWithFeaturesStraightAndGivenValuesKept) {
  std::mt19937 random(5);
  int spoiled = 0;
  for (const test::CreasedShape& shape : test::creasedShapes()) {
    PreparedSurface surface(shape.mesh);
    const Solved map(shape, surface);
    const SeamlessSystem system = systemOf(shape.mesh, map.setup.seamless);
    double size = 0.0;
    for (const FaceId f : shape.mesh.faces()) size += doubleArea(map, map.result.z, f);
    size = std::sqrt(size / shape.mesh.faceCount());
    Eigen::VectorXd x = map.result.x;
    std::vector<std::pair<int, double>> given;
    for (int i = 0; i < map.setup.unknowns.count; ++i) {
      if (i % 5 == 0) given.push_back({i, x[i]});
      x[i] += size * (1e-9 * static_cast<double>(random()) - 2.0);
    }
    spoiled += turned(shape.mesh, map, placesOf(map.setup.unknowns, x));
    UntangleOptions options;
    options.u = map.setup.seamless.field.u;
    options.kept = map.setup.base;
    const StraightUntangling result =
        untangleStraight(straightSystemOf(map.setup, system), x, given,
                         map.setup.seamless.seams.frameAngle, options);
    EXPECT_EQ(result.flipped, 0) << shape.name;
    EXPECT_EQ(turned(shape.mesh, map, result.z), 0) << shape.name;
    for (const auto& [unknown, value] : given) EXPECT_EQ(result.x[unknown], value) << shape.name;
    for (const StraightEdge& e : map.setup.edges) {
      const Complex a = result.z[at(copyOf(map, e.h))];
      const Complex b = result.z[at(copyOf(map, TriMesh::next(e.h)))];
      EXPECT_TRUE(e.heading % 2 == 0 ? a.imag() == b.imag() : a.real() == b.real()) << shape.name;
    }
  }
  EXPECT_GT(spoiled, 1000);
}

/// Gaps of a map with other nodes.
struct Gaps {
  Gaps(const test::CreasedShape& shape, const Solved& map, const PerVertex<char>& isNode,
       double reach = 1e300)
      : unknowns(map.setup.unknowns),
        list(lineGaps(
            {shape.mesh, map.setup.seamless.cut, map.setup.aligned.sectors, map.setup.unknowns,
             map.result.z, isNode, map.setup.seamless.cones, map.setup.aligned.index},
            reach)) {}

  /// The one of copy `to` minus copy `from` along an axis.
  const LineGap* find(int from, int to, int axis, double sign) const {
    RealSum sum;
    for (const auto& [unknown, factor] : partOf(unknowns, to, axis)) sum[unknown] += sign * factor;
    for (const auto& [unknown, factor] : partOf(unknowns, from, axis))
      sum[unknown] -= sign * factor;
    std::erase_if(sum, [](const auto& term) { return term.second == 0.0; });
    const auto found =
        std::find_if(list.begin(), list.end(), [&](const LineGap& gap) { return gap.sum == sum; });
    return found == list.end() ? nullptr : &*found;
  }

  const RealUnknowns& unknowns;
  std::vector<LineGap> list;
};

double partOf(const Complex& z, int axis) { return axis == 0 ? z.real() : z.imag(); }

TEST(LineGaps, AreTheDistancesOfTheMap) {
  for (const test::CreasedShape& shape : test::creasedShapes()) {
    PreparedSurface surface(shape.mesh);
    const Solved map(shape, surface);
    const Gaps gaps(shape, map, PerVertex<char>(at(shape.mesh.vertexCount()), 1));
    EXPECT_FALSE(gaps.list.empty()) << shape.name;
    for (const LineGap& gap : gaps.list) {
      double value = 0.0, scale = 0.0;
      for (const auto& [unknown, factor] : gap.sum) {
        value += factor * map.result.x[unknown];
        scale += std::fabs(factor * map.result.x[unknown]);
      }
      EXPECT_NEAR(value, gap.length, 1e-9 * (1.0 + scale)) << shape.name;
    }
  }
}

/// The feature halfedge that a ray from a corner along an axis meets first, walking over edges that are no seams: an
/// invalid one where it leaves the corner elsewhere, or meets a seam or a vertex.
HalfedgeId facedBy(const TriMesh& mesh, const Solved& map, HalfedgeId corner, Complex way) {
  const auto side = [&](HalfedgeId h) {
    const Complex d = map.result.z[at(copyOf(map, h))] - map.result.z[at(copyOf(map, corner))];
    return way.real() * d.imag() - way.imag() * d.real();
  };
  HalfedgeId over = TriMesh::next(corner);
  for (int n = 0; n < mesh.faceCount(); ++n) {
    if (!(side(over) < -1e-9 && side(TriMesh::next(over)) > 1e-9)) return {};
    if (map.setup.aligned.sectors.isFeature[mesh.edge(over)] != 0) return over;
    if (map.setup.seamless.cut.isSeam[mesh.edge(over)] != 0) return {};
    const HalfedgeId beyond = mesh.twin(over);
    const HalfedgeId right = TriMesh::next(beyond), left = TriMesh::previous(beyond);
    over = side(left) > 0.0 ? right : left;
  }
  return {};
}

TEST(LineGaps, EndsAndCornersKeepFromTheLinesThatTheyFace) {
  int faced = 0;
  for (const test::CreasedShape& shape : test::creasedShapes()) {
    PreparedSurface surface(shape.mesh);
    const Solved map(shape, surface);
    const Sectors& sectors = map.setup.aligned.sectors;
    const Gaps gaps(shape, map, PerVertex<char>(at(shape.mesh.vertexCount()), 1));
    for (const HalfedgeId corner : shape.mesh.halfedges()) {
      if (!sectors.isOnFeature[shape.mesh.tail(corner)]) continue;
      for (int d = 0; d < 4; ++d) {
        const HalfedgeId line = facedBy(shape.mesh, map, corner, rotation(d, 4));
        if (!line.isValid()) continue;
        const int from = copyOf(map, corner), to = copyOf(map, line);
        EXPECT_TRUE(gaps.find(from, to, d % 2, d < 2 ? 1.0 : -1.0))
            << shape.name << " vertex " << shape.mesh.tail(corner).i << " direction " << d;
        ++faced;
      }
    }
  }
  EXPECT_GT(faced, 100);
}

TEST(LineGaps, NoneAsksForMoreThanASlightMoveWhereTheMapIsNotAsAsked) {
  constexpr double kReach = 1.2;
  int slight = 0;
  for (const test::CreasedShape& shape : test::creasedShapes()) {
    PreparedSurface surface(shape.mesh);
    const Solved map(shape, surface);
    const Gaps gaps(shape, map, PerVertex<char>(at(shape.mesh.vertexCount()), 1), kReach);
    for (const LineGap& gap : gaps.list) {
      EXPECT_GE(gap.length, gap.mayVanish ? -kReach / 24.0 : 0.0) << shape.name;
      slight += gap.length < 0.0 ? 1 : 0;
    }
  }
  EXPECT_GT(slight, 0);
}

TEST(LineGaps, OfThreePointsInATriangleTheMiddleOneStaysOnItsSide) {
  int looked = 0;
  for (const test::CreasedShape& shape : test::creasedShapes()) {
    PreparedSurface surface(shape.mesh);
    const Solved map(shape, surface);
    const Gaps gaps(shape, map, PerVertex<char>(at(shape.mesh.vertexCount()), 1));
    const std::vector<Complex>& z = map.result.z;
    for (const FaceId f : shape.mesh.faces()) {
      std::array<int, 3> c{};
      for (int k = 0; k < 3; ++k) c[at(k)] = copyOf(map, TriMesh::halfedge(f, k));
      const auto extent = [&](int axis) {
        const auto [low, high] = std::minmax(
            {partOf(z[at(c[0])], axis), partOf(z[at(c[1])], axis), partOf(z[at(c[2])], axis)});
        return high - low;
      };
      if (std::fabs(extent(0) - extent(1)) < 1e-9) continue;  // either will do
      const int axis = extent(0) > extent(1) ? 0 : 1;
      std::sort(c.begin(), c.end(),
                [&](int a, int b) { return partOf(z[at(a)], axis) < partOf(z[at(b)], axis); });
      const auto isTied = [&](int a, int b) {
        return std::fabs(partOf(z[at(a)], axis) - partOf(z[at(b)], axis)) < 1e-9;
      };
      if (isTied(c[0], c[1]) || isTied(c[1], c[2])) continue;  // either is in the middle
      ++looked;
      const auto height = [&](int other) {
        return partOf(z[at(c[1])], 1 - axis) - partOf(z[at(other)], 1 - axis);
      };
      const bool isFirst = std::fabs(height(c[0])) >= std::fabs(height(c[2]));
      const int far = isFirst ? c[0] : c[2];
      const double sign = height(far) > 0.0 ? 1.0 : -1.0;
      const LineGap* gap = gaps.find(far, c[1], 1 - axis, sign);
      ASSERT_TRUE(gap) << shape.name << " triangle " << f.i;
      EXPECT_FALSE(gap->mayVanish) << shape.name << " triangle " << f.i;
    }
  }
  EXPECT_GT(looked, 1000);
}

}  // namespace
}  // namespace hgp
