// The elimination order of real unknowns.  Law: unknowns that a harmonic row or a coordinate of a triangle couples lie on one path
// to the root, so that separate branches are not coupled.
#include "hgp/optimize/real_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "hgp/parametrize/along/straight_setup.h"
#include "support/creases.h"

namespace hgp {
namespace {

/// Sets of unknowns that are coupled pairwise: found by what each unknown alone does to rows and triangles.
std::vector<std::set<int>> coupledSets(const TriMesh& mesh, const StraightSetup& setup) {
  const SeamlessSetup& seamless = setup.seamless;
  const auto rows = at(mesh.vertexCount()), faces = at(mesh.faceCount());
  std::vector<std::set<int>> sets(2 * (rows + faces));
  for (int i = 0; i < setup.unknowns.count; ++i) {
    const std::vector<Complex> z =
        placesOf(setup.unknowns, Eigen::VectorXd::Unit(setup.unknowns.count, i));
    const auto placeAt = [&](HalfedgeId h) { return z[at(seamless.cut.copy[h].i)]; };
    const auto note = [&](std::size_t where, const Complex& value) {
      if (std::abs(value.real()) > 1e-12) sets[2 * where].insert(i);
      if (std::abs(value.imag()) > 1e-12) sets[2 * where + 1].insert(i);
    };
    for (VertexId v : mesh.vertices()) {
      if (!setup.hasRow[v]) continue;
      Complex sum = 0.0;
      for (HalfedgeId h : outgoingHalfedges(mesh, v)) {
        const int turn = seamless.unknowns.turn[seamless.cut.copy[h]];
        const double weight = 1.0 + 0.01 * h.i;  // nothing cancels by chance
        sum += rotation(-turn, 4) * (2.0 * placeAt(h) - weight * placeAt(TriMesh::next(h)) -
                                     placeAt(TriMesh::previous(h)));
      }
      note(at(v.i), sum);
    }
    for (FaceId f : mesh.faces())
      for (int k = 0; k < 3; ++k) note(rows + at(f.i), placeAt(TriMesh::halfedge(f, k)));
  }
  return sets;
}

TEST(RealTree, SeparatesWhatRowsAndTrianglesDoNotCouple) {
  std::vector<test::CreasedShape> shapes = test::creasedShapes();
  // Large enough to be dissected several times, with seams that turn beside creases.
  for (const test::Shape& fine : {test::jittered(test::cube(12), 0.01), test::pretzel(2, 3)}) {
    TriMesh mesh = fine.mesh();
    std::vector<EdgeId> features = test::creasesOf(mesh);
    shapes.push_back({fine.name, std::move(mesh), std::move(features)});
  }
  for (const test::CreasedShape& shape : shapes) {
    PreparedSurface surface(shape.mesh);
    std::vector<StageTime> times;
    const Result<StraightSetup> setup =
        prepareStraight(surface, shape.features, HolonomySpec{}, {}, times);
    ASSERT_TRUE(setup) << shape.name;
    const SeamlessSystem system = systemOf(shape.mesh, setup->seamless);
    std::vector<int> number(at(setup->unknowns.count));
    std::iota(number.begin(), number.end(), 0);
    const linalg::SeparatorTree tree =
        setup->tree->get(system, setup->unknowns, setup->hasRow, number);
    std::vector<int> node(number.size(), -1);
    for (int t = 0; t < tree.nodeCount(); ++t)
      for (int k = tree.nodeStart[at(t)]; k < tree.nodeStart[at(t + 1)]; ++k)
        node[at(tree.order[at(k)])] = t;
    ASSERT_EQ(tree.order.size(), number.size()) << shape.name;
    ASSERT_EQ(std::count(node.begin(), node.end(), -1), 0) << shape.name;
    const auto isAbove = [&](int up, int down) {
      while (down >= 0 && down < up) down = tree.parent[at(down)];
      return down == up;
    };
    std::size_t pairs = 0;
    for (const std::set<int>& coupled : coupledSets(shape.mesh, *setup))
      for (const int i : coupled)
        for (const int j : coupled) {
          const auto [low, high] = std::minmax(node[at(i)], node[at(j)]);
          ASSERT_TRUE(isAbove(high, low)) << shape.name << ": " << i << " and " << j;
          ++pairs;
        }
    EXPECT_GT(pairs, number.size()) << shape.name;
    // Without some of them, the others keep their order.
    int kept = 0;
    for (std::size_t i = 0; i < number.size(); ++i) number[i] = i % 3 == 0 ? -1 : kept++;
    std::vector<int> left;
    for (const int i : tree.order)
      if (i % 3 != 0) left.push_back(number[at(i)]);
    EXPECT_EQ(setup->tree->get(system, setup->unknowns, setup->hasRow, number).order, left);
  }
}

}  // namespace
}  // namespace hgp
