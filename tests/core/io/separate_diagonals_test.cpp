// Triangulating polygons makes no face and no edge that the file does not have.
#include "hgp/io/polygon/separate_diagonals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "hgp/io/polygon/ear_clipping.h"
#include "hgp/io/polygon/polygon_mesh.h"

namespace hgp::io {
namespace {

using Ring = std::vector<int>;

PolygonMesh meshOf(std::vector<Vec3> positions, const std::vector<Ring>& rings) {
  PolygonMesh mesh;
  mesh.positions = std::move(positions);
  for (const Ring& ring : rings) {
    mesh.cornerVertex.insert(mesh.cornerVertex.end(), ring.begin(), ring.end());
    mesh.start.push_back(static_cast<std::uint32_t>(mesh.cornerVertex.size()));
  }
  return mesh;
}

std::vector<std::array<int, 3>> sortedTriangles(const MeshData& mesh) {
  std::vector<std::array<int, 3>> out = mesh.triangles;
  for (auto& t : out) std::sort(t.begin(), t.end());
  std::sort(out.begin(), out.end());
  return out;
}

MeshData triangulated(const PolygonMesh& polygons) {
  const Result<TriangleCorners> corners = triangulate(polygons);
  EXPECT_TRUE(corners);
  return triangleMesh(polygons, *corners);
}

int repeats(const MeshData& mesh) {
  const auto t = sortedTriangles(mesh);
  int count = 0;
  for (std::size_t i = 1; i < t.size(); ++i) count += t[i] == t[i - 1];
  return count;
}

/// Edges with more than two triangles.
int crowdedEdges(const MeshData& mesh) {
  std::map<std::pair<int, int>, int> faces;
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) ++faces[std::minmax({t[k], t[(k + 1) % 3]})];
  return static_cast<int>(
      std::count_if(faces.begin(), faces.end(), [](const auto& e) { return e.second > 2; }));
}

/// A torus of m × n quadrilaterals whose vertices are moved at random.
struct Quads {
  std::vector<Vec3> positions;
  std::vector<Ring> rings;
  std::mt19937 random;

  Quads(int m, int n, unsigned seed) : random(seed) {
    for (int i = 0; i < m; ++i)
      for (int j = 0; j < n; ++j) {
        const double a = 6.283185307179586 * i / m, b = 6.283185307179586 * j / n;
        positions.push_back({(2 + std::cos(b)) * std::cos(a) + noise(),
                             (2 + std::cos(b)) * std::sin(a) + noise(), std::sin(b) + noise()});
        const auto at = [&](int k, int l) { return (k % m) * n + l % n; };
        rings.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
      }
  }
  double noise() { return std::uniform_real_distribution(-0.08, 0.08)(random); }
  std::size_t any() { return random() % rings.size(); }

  /// Two quadrilaterals in place of one, which share two edges and a vertex that only they have.
  void addDoublet(std::size_t at) {
    const Ring ring = rings[at];
    Vec3 middle{0, 0, 0};
    for (const int v : ring)
      for (std::size_t k = 0; k < 3; ++k)
        middle[k] += positions[static_cast<std::size_t>(v)][k] / 4;
    for (double& x : middle) x += 3 * noise();
    const int x = static_cast<int>(positions.size());
    positions.push_back(middle);
    rings[at] = {ring[0], ring[1], ring[2], x};
    rings.push_back({ring[0], x, ring[2], ring[3]});
  }
  /// One of the two triangles of a quadrilateral as a face of its own.
  void addFin(std::size_t at) {
    const Ring ring = rings[at];
    const std::size_t k = random() % 4;
    rings.push_back({ring[k], ring[(k + 1) % 4], ring[(k + 2) % 4]});
  }
  void addCopy(std::size_t at) {
    Ring ring = rings[at];
    std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(random() % 4), ring.end());
    if (random() % 2) std::reverse(ring.begin(), ring.end());
    rings.push_back(ring);
  }
};

TEST(SeparateDiagonals, ADoubletHasFourTriangles) {
  const PolygonMesh mesh = meshOf({{0, 0, 0}, {.1, -2, 0}, {.2, 0, 0}, {.1, .02, .5}, {.1, 2, 0}},
                                  {{0, 1, 2, 3}, {0, 3, 2, 4}});
  const MeshData data = triangulated(mesh);
  EXPECT_EQ(repeats(data), 0);
  EXPECT_EQ(crowdedEdges(data), 0);
}

TEST(SeparateDiagonals, DoubletsMakeNoFaceAndNoEdgeTwice) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    Quads quads(7, 6, seed);
    for (int n = 0; n < 8; ++n) quads.addDoublet(quads.any());
    const MeshData data = triangulated(meshOf(quads.positions, quads.rings));
    EXPECT_EQ(repeats(data), 0) << seed;
    EXPECT_EQ(crowdedEdges(data), 0) << seed;
    EXPECT_EQ(data.triangles.size(), 2 * quads.rings.size());
  }
}

TEST(SeparateDiagonals, AFinNextToAQuadrilateralIsNoHalfOfIt) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    Quads quads(7, 6, seed);
    std::set<std::size_t> used;
    for (int n = 0; n < 5; ++n)
      if (const std::size_t at = quads.random() % 42; used.insert(at).second) quads.addFin(at);
    EXPECT_EQ(repeats(triangulated(meshOf(quads.positions, quads.rings))), 0) << seed;
  }
}

TEST(SeparateDiagonals, RepeatedPolygonsGetTheSameTriangles) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    Quads quads(7, 6, seed);
    for (int n = 0; n < 4; ++n) quads.addDoublet(quads.any());
    const std::size_t before = quads.rings.size();
    std::set<std::size_t> copied;
    while (copied.size() < 6) copied.insert(quads.random() % before);
    for (const std::size_t at : copied) quads.addCopy(at);
    const MeshData data = triangulated(meshOf(quads.positions, quads.rings));
    EXPECT_EQ(repeats(data), 12) << seed;
    // Every triangle keeps the cyclic order of its polygon.
    for (std::size_t t = 0; t < data.triangles.size(); ++t) {
      const Ring& ring = quads.rings[t / 2];
      std::array<int, 3> at{};
      for (std::size_t k = 0; k < 3; ++k)
        at[k] = static_cast<int>(std::find(ring.begin(), ring.end(), data.triangles[t][k]) -
                                 ring.begin());
      ASSERT_EQ((at[1] - at[0] + 4) % 4 + (at[2] - at[1] + 4) % 4 + (at[0] - at[2] + 4) % 4, 4);
    }
  }
}

TEST(SeparateDiagonals, VerticesAtOnePlaceCountAsOne) {
  Quads quads(7, 6, 3);
  for (int n = 0; n < 8; ++n) quads.addDoublet(quads.any());
  std::vector<Vec3> positions;
  std::vector<Ring> rings;
  for (const Ring& ring : quads.rings) {  // every polygon has its own vertices
    rings.emplace_back();
    for (const int v : ring) {
      rings.back().push_back(static_cast<int>(positions.size()));
      positions.push_back(quads.positions[static_cast<std::size_t>(v)]);
    }
  }
  const Result<TriangleCorners> joined = triangulate(meshOf(quads.positions, quads.rings));
  const Result<TriangleCorners> apart = triangulate(meshOf(positions, rings));
  ASSERT_TRUE(joined && apart);
  EXPECT_EQ(*joined, *apart);
}

TEST(SeparateDiagonals, OtherPolygonsKeepTheirTriangles) {
  Quads quads(9, 8, 5);
  quads.addDoublet(11);
  const PolygonMesh mesh = meshOf(quads.positions, quads.rings);
  const Result<TriangleCorners> corners = triangulate(mesh);
  ASSERT_TRUE(corners);
  std::int64_t tests = 0;
  int changed = 0;
  for (int p = 0; p < mesh.polygonCount(); ++p) {
    std::vector<Vec3> points;
    for (const int v : quads.rings[static_cast<std::size_t>(p)])
      points.push_back(quads.positions[static_cast<std::size_t>(v)]);
    auto own = clipEars(points, {0, 0, 0}, tests);
    for (auto& t : own)
      for (int& c : t) c += static_cast<int>(mesh.start[static_cast<std::size_t>(p)]);
    for (std::size_t k = 0; k < 2; ++k)
      changed += own[k] != (*corners)[static_cast<std::size_t>(mesh.firstTriangle(p)) + k];
  }
  EXPECT_LE(changed, 2);
}

/// A box of 4 × 4 × 6 squares, the last along the axis, around (offset, offset, offset); corner lists start anywhere.
PolygonMesh boxOfSquares(std::size_t axis, double offset, std::mt19937& random) {
  constexpr int kHalf = 2, kHeight = 3;
  std::vector<Vec3> positions;
  std::map<std::array<int, 3>, int> ids;
  std::vector<Ring> rings;
  const auto vertex = [&](int x, int y, int z) {
    const auto [it, isNew] = ids.try_emplace({x, y, z}, static_cast<int>(positions.size()));
    Vec3 p{};
    for (std::size_t k = 0; k < 3; ++k)
      p[(axis + k) % 3] = offset + 0.1 * (k == 0 ? z : k == 1 ? x : y);
    if (isNew) positions.push_back(p);
    return it->second;
  };
  const auto add = [&](Ring ring) {
    std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(random() % 4), ring.end());
    rings.push_back(ring);
  };
  for (int x = -kHalf; x < kHalf; ++x)
    for (int y = -kHalf; y < kHalf; ++y) {
      add({vertex(x, y, kHeight), vertex(x + 1, y, kHeight), vertex(x + 1, y + 1, kHeight),
           vertex(x, y + 1, kHeight)});
      add({vertex(x, y, -kHeight), vertex(x, y + 1, -kHeight), vertex(x + 1, y + 1, -kHeight),
           vertex(x + 1, y, -kHeight)});
    }
  for (int s = -kHalf; s < kHalf; ++s)
    for (int z = -kHeight; z < kHeight; ++z)
      for (const int side : {-kHalf, kHalf}) {
        add({vertex(side, s, z), vertex(side, s + 1, z), vertex(side, s + 1, z + 1),
             vertex(side, s, z + 1)});
        add({vertex(s, side, z), vertex(s + 1, side, z), vertex(s + 1, side, z + 1),
             vertex(s, side, z + 1)});
      }
  return meshOf(std::move(positions), rings);
}

TEST(Triangulate, EquallyGoodDiagonalsAreMirroredAsTheQuadrilateralsAre) {
  std::mt19937 random(3);
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const double offset : {0.0, 7.3}) {
      const MeshData mesh = triangulated(boxOfSquares(axis, offset, random));
      for (std::size_t across = 0; across < 3; ++across) {
        std::vector<int> image;
        for (Vec3 p : mesh.positions) {
          p[across] = 2 * offset - p[across];
          const auto it =
              std::find_if(mesh.positions.begin(), mesh.positions.end(), [&](const Vec3& other) {
                return std::fabs(p[0] - other[0]) + std::fabs(p[1] - other[1]) +
                           std::fabs(p[2] - other[2]) <
                       1e-9;
              });
          image.push_back(static_cast<int>(it - mesh.positions.begin()));
        }
        MeshData other = mesh;
        for (auto& t : other.triangles)
          for (int& v : t) v = image[static_cast<std::size_t>(v)];
        EXPECT_EQ(sortedTriangles(other), sortedTriangles(mesh)) << axis << across << offset;
      }
    }
}

}  // namespace
}  // namespace hgp::io
