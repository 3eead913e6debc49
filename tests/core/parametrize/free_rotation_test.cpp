#include "hgp/parametrize/after/free_rotation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "hgp/parametrize/parametrize.h"
#include "support/prescriptions.h"
#include "support/shapes.h"

namespace hgp {
namespace {

Complex edgeOf(const UvMap& map, FaceId f, std::size_t k) {
  const auto& corners = map.cornerUv[static_cast<std::size_t>(f.i)];
  const auto at = [&](std::size_t corner) {
    const Vec2& p = map.uv[static_cast<std::size_t>(corners[corner % 3])];
    return Complex(p[0], p[1]);
  };
  return at(k + 1) - at(k);
}

Result<Parametrization> mapOf(const TriMesh& mesh, const HolonomySpec& spec) {
  return parametrize(mesh, spec, {});
}

TEST(FreeRotation, CreasesFollowTheAxes) {
  const TriMesh cube = test::cube(5).mesh();
  const Geometry geometry = computeGeometry(cube);
  HolonomySpec corners;
  for (VertexId v : cube.vertices())
    if (geometry.angleSum[v] < 1.75 * kPi) corners.cones.push_back({v, 3});
  const Result<Parametrization> run = mapOf(cube, corners);
  ASSERT_TRUE(run && run->isCertified);
  double least = 1e300, most = -1e300;
  for (VertexId v : cube.vertices()) {
    least = std::min(least, cube.position(v)[0]);
    most = std::max(most, cube.position(v)[0]);
  }
  // On an edge of the cube, two coordinates are extreme, and the same at both ends.
  const auto isCrease = [&](VertexId v, VertexId w) {
    int fixed = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double x = cube.position(v)[k];
      fixed += std::abs(x - cube.position(w)[k]) < 1e-9 &&
               std::min(std::abs(x - least), std::abs(x - most)) < 1e-9;
    }
    return fixed == 2;
  };
  int creases = 0;
  for (FaceId f : cube.faces())
    for (int k = 0; k < 3; ++k) {
      const HalfedgeId h = TriMesh::halfedge(f, k);
      if (!isCrease(cube.tail(h), cube.head(h))) continue;
      const Complex e = edgeOf(run->map, f, static_cast<std::size_t>(k));
      EXPECT_LT(std::min(std::abs(e.real()), std::abs(e.imag())), 1e-6 * std::abs(e));
      ++creases;
    }
  EXPECT_GT(creases, 50);
}

/// The same surface with its triangles listed in another order, each from another corner on.
struct Shuffled {
  MeshData data;
  std::vector<int> given;  ///< face → face of the original
  std::vector<int> first;  ///< its corner 0 → corner of the original
};

Shuffled shuffled(const test::Shape& shape, unsigned seed) {
  std::mt19937 random(seed);
  Shuffled out;
  out.data.positions = shape.data.positions;
  const int count = static_cast<int>(shape.data.triangles.size());
  for (int f = 0; f < count; ++f) out.given.push_back(f);
  std::shuffle(out.given.begin(), out.given.end(), random);
  for (const int f : out.given) {
    const int turn = static_cast<int>(random() % 3);
    const auto& t = shape.data.triangles[static_cast<std::size_t>(f)];
    out.first.push_back(turn);
    const auto at = [&](int k) { return t[static_cast<std::size_t>((k + turn) % 3)]; };
    out.data.triangles.push_back({at(0), at(1), at(2)});
  }
  return out;
}

TEST(FreeRotation, TheOrderOfTheFileTurnsTheMapByAMultipleOfAQthTurn) {
  for (const int q : {2, 3, 4, 6})
    for (const test::Shape& shape :
         {test::jittered(test::icosphere(6), 0.05), test::jittered(test::disk(6), 0.03)}) {
      const TriMesh mesh = shape.mesh();
      HolonomySpec spec;
      spec.q = q;
      if (shape.name.find("disk") == std::string::npos)
        for (const VertexId v : test::spreadVertices(mesh, 2 * q)) spec.cones.push_back({v, q - 1});
      const Result<Parametrization> first = mapOf(mesh, spec);
      ASSERT_TRUE(first) << shape.name << q;
      const Shuffled other = shuffled(shape, 5);
      const Result<TriMesh> again = buildTriMesh(other.data);
      ASSERT_TRUE(again);
      const Result<Parametrization> second = mapOf(*again, spec);
      ASSERT_TRUE(second);
      ASSERT_EQ(first->isCertified, second->isCertified) << shape.name << q;
      for (std::size_t f = 0; f < other.given.size(); ++f) {
        const Complex a =
            edgeOf(first->map, FaceId(other.given[f]), static_cast<std::size_t>(other.first[f]));
        const Complex b = edgeOf(second->map, FaceId(static_cast<int>(f)), 0);
        ASSERT_LT(std::abs(std::pow(b / a, q) - 1.0), 1e-5) << shape.name << " q=" << q;
      }
    }
}

}  // namespace
}  // namespace hgp
