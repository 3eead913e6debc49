#include "support/shapes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <random>
#include <set>

namespace hgp::test {
namespace {

/// Vertices shared by a key, so that pieces glue where keys agree.
template <class Key>
class Welder {
 public:
  explicit Welder(MeshData& data) : data_(&data) {}
  int operator()(const Key& key, const Vec3& position) {
    const auto [it, isNew] = ids_.try_emplace(key, static_cast<int>(data_->positions.size()));
    if (isNew) data_->positions.push_back(position);
    return it->second;
  }

 private:
  MeshData* data_;
  std::map<Key, int> ids_;
};

void addQuad(MeshData& data, int a, int b, int c, int d) {
  data.triangles.push_back({a, b, c});
  data.triangles.push_back({a, c, d});
}

using Cell = std::array<int, 3>;

/// The surface of a set of unit cells, each square cut into n × n; positions times `scale`.
MeshData voxelSurface(const std::set<Cell>& cells, int n, double scale) {
  MeshData data;
  Welder<Cell> weld(data);
  const auto vertex = [&](const Cell& p) {
    return weld(p, {scale * p[0] / n, scale * p[1] / n, scale * p[2] / n});
  };
  for (const Cell& cell : cells)
    for (int axis = 0; axis < 3; ++axis)
      for (int side = 0; side < 2; ++side) {
        Cell neighbour = cell;
        neighbour[at(axis)] += side ? 1 : -1;
        if (cells.count(neighbour)) continue;
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        for (int i = 0; i < n; ++i)
          for (int j = 0; j < n; ++j) {
            const auto corner = [&](int di, int dj) {
              Cell p{cell[0] * n, cell[1] * n, cell[2] * n};
              p[at(axis)] += side * n;
              p[at(u)] += i + di;
              p[at(v)] += j + dj;
              return vertex(p);
            };
            const int a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
            if (side)
              addQuad(data, a, b, c, d);
            else
              addQuad(data, a, d, c, b);
          }
      }
  return data;
}

/// m × n quads of a rectangle, with i = m glued to i = 0 (and j = n to j = 0) where asked.
template <class Position>
MeshData lattice(int m, int n, bool isRoundU, bool isRoundV, Position position) {
  MeshData data;
  const int columns = isRoundU ? m : m + 1, rows = isRoundV ? n : n + 1;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) data.positions.push_back(position(i, j));
  const auto id = [&](int i, int j) { return (j % rows) * columns + i % columns; };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < m; ++i)
      addQuad(data, id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1));
  return data;
}

constexpr double kTau = 6.283185307179586476925;

Vec3 torusPoint(int i, int m, int j, int n) {
  const double a = kTau * i / m, b = kTau * j / n, r = 1.0 + 0.4 * std::cos(b);
  return {r * std::cos(a), r * std::sin(a), 0.4 * std::sin(b)};
}

}  // namespace

TriMesh meshOf(const MeshData& data) {
  Result<TriMesh> mesh = buildTriMesh(data);
  if (!mesh) {
    std::fprintf(stderr, "not a manifold: %s\n", mesh.error().message.c_str());
    std::abort();
  }
  return *std::move(mesh);
}

TriMesh Shape::mesh() const { return meshOf(data); }

Shape tetrahedron() {
  return {"tetrahedron",
          {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
           {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}},
          0,
          0};
}

Shape octahedron() {
  return {
      "octahedron",
      {{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
       {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}}},
      0,
      0};
}

Shape cube(int n) { return {"cube", voxelSurface({{0, 0, 0}}, n, 1.0), 0, 0}; }

Shape icosphere(int n) {
  const double p = (1.0 + std::sqrt(5.0)) / 2.0;
  const std::vector<Vec3> base{{-1, p, 0}, {1, p, 0}, {-1, -p, 0}, {1, -p, 0},
                               {0, -1, p}, {0, 1, p}, {0, -1, -p}, {0, 1, -p},
                               {p, 0, -1}, {p, 0, 1}, {-p, 0, -1}, {-p, 0, 1}};
  const std::vector<std::array<int, 3>> faces{
      {0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
      {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
      {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  Shape shape{"icosphere", {}, 0, 0};
  // A vertex is known by its barycentric weights on the corners of the icosahedron.
  Welder<std::vector<std::pair<int, int>>> weld(shape.data);
  for (const auto& t : faces) {
    const auto vertex = [&](int i, int j) {
      std::vector<std::pair<int, int>> key{{t[0], n - i - j}, {t[1], i}, {t[2], j}};
      std::sort(key.begin(), key.end());
      key.erase(std::remove_if(key.begin(), key.end(), [](auto& w) { return w.second == 0; }),
                key.end());
      Vec3 x{0, 0, 0};
      for (const auto& [v, w] : key)
        for (std::size_t c = 0; c < 3; ++c) x[c] += w * base[at(v)][c];
      const double length = std::hypot(x[0], x[1], x[2]);
      return weld(key, {x[0] / length, x[1] / length, x[2] / length});
    };
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j) {
        shape.data.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i, j + 1)});
        if (i + j + 1 < n)
          shape.data.triangles.push_back(
              {vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
      }
  }
  return shape;
}

Shape torus(int m, int n) {
  const auto point = [=](int i, int j) { return torusPoint(i, m, j, n); };
  return {"torus", lattice(m, n, true, true, point), 1, 0};
}

Shape pretzel(int genus, int n) {
  std::set<Cell> cells;
  for (int x = 0; x < 2 * genus + 1; ++x)
    for (int y = 0; y < 3; ++y)
      if (y != 1 || x % 2 == 0) cells.insert({x, y, 0});
  return {"pretzel" + std::to_string(genus), voxelSurface(cells, n, 1.0), genus, 0};
}

Shape triangle() { return {"triangle", {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}, 0, 1}; }

Shape grid(int m, int n) {
  const auto point = [](int i, int j) { return Vec3{double(i), double(j), 0}; };
  return {"grid", lattice(m, n, false, false, point), 0, 1};
}

Shape disk(int n) {
  Shape shape{"disk", {}, 0, 1};
  auto& data = shape.data;
  data.positions.push_back({0, 0, 0});
  const auto id = [](int ring, int i) {
    return ring == 0 ? 0 : 3 * ring * (ring - 1) + 1 + i % (6 * ring);
  };
  for (int ring = 1; ring <= n; ++ring)
    for (int i = 0; i < 6 * ring; ++i) {
      const double a = kTau * i / (6 * ring), r = double(ring) / n;
      data.positions.push_back({r * std::cos(a), r * std::sin(a), 0});
    }
  for (int ring = 0; ring < n; ++ring)
    for (int sector = 0; sector < 6; ++sector)
      for (int i = 0; i <= ring; ++i) {
        const int in = id(ring, sector * ring + i), out = id(ring + 1, sector * (ring + 1) + i);
        const int outNext = id(ring + 1, sector * (ring + 1) + i + 1);
        data.triangles.push_back({in, out, outNext});
        if (i < ring) data.triangles.push_back({in, outNext, id(ring, sector * ring + i + 1)});
      }
  return shape;
}

Shape annulus(int m, int n) {
  // Radius outwards, angle clockwise in the lattice's order would face down: run the angle first.
  const auto point = [=](int i, int j) {
    const double a = -kTau * i / m, r = 1.0 + double(j) / n;
    return Vec3{r * std::cos(a), r * std::sin(a), 0};
  };
  return {"annulus", lattice(m, n, true, false, point), 0, 2};
}

Shape cylinder(int m, int n) {
  const auto point = [=](int i, int j) {
    const double a = kTau * i / m;
    return Vec3{std::cos(a), std::sin(a), double(j) * kTau / m};
  };
  return {"cylinder", lattice(m, n, true, false, point), 0, 2};
}

Shape puncturedTorus(int m, int n) {
  Shape shape = torus(m, n);
  shape.name = "puncturedTorus";
  shape.data.triangles.erase(shape.data.triangles.begin(), shape.data.triangles.begin() + 2);
  shape.loops = 1;
  return shape;
}

Shape withoutFaces(Shape shape, const std::vector<int>& faces) {
  std::vector<int> order(faces);
  std::sort(order.rbegin(), order.rend());
  for (int f : order) shape.data.triangles.erase(shape.data.triangles.begin() + f);
  shape.loops += static_cast<int>(faces.size());
  shape.name += "-" + std::to_string(faces.size()) + "holes";
  return shape;
}

Shape jittered(Shape shape, double amount, unsigned seed) {
  std::mt19937 random(seed);
  // Not std::uniform_real_distribution: its values differ between standard libraries.
  const auto next = [&] { return 2.0 * (static_cast<double>(random()) / 4294967296.0) - 1.0; };
  for (Vec3& p : shape.data.positions)
    for (double& x : p) x += amount * next();
  shape.name += "-jittered";
  return shape;
}

Shape scattered(Shape shape, unsigned seed) {
  std::mt19937 random(seed);
  const auto shuffle = [&](auto& items) {
    for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[random() % i]);
  };
  shuffle(shape.data.triangles);
  std::vector<int> old(shape.data.positions.size());
  for (std::size_t v = 0; v < old.size(); ++v) old[v] = static_cast<int>(v);
  shuffle(old);
  const MeshData before = shape.data;
  std::vector<int> now(old.size());
  for (std::size_t v = 0; v < old.size(); ++v) {
    now[static_cast<std::size_t>(old[v])] = static_cast<int>(v);
    shape.data.positions[v] = before.positions[static_cast<std::size_t>(old[v])];
  }
  for (auto& t : shape.data.triangles)
    for (int& v : t) v = now[static_cast<std::size_t>(v)];
  shape.name += "-scattered";
  return shape;
}

std::vector<Shape> closed() {
  return {tetrahedron(), octahedron(),  cube(1),
          cube(3),       icosphere(1),  icosphere(3),
          torus(3, 3),   torus(8, 5),   jittered(torus(12, 7), 0.03),
          doubleTorus(), pretzel(3, 2), pretzel(5)};
}

std::vector<Shape> withBoundary() {
  return {triangle(),
          grid(1, 1),
          grid(4, 3),
          disk(1),
          disk(4),
          annulus(6, 2),
          cylinder(5, 3),
          puncturedTorus(5, 4),
          withoutFaces(icosphere(3), {0, 60, 120}),
          withoutFaces(doubleTorus(2), {0, 200}),
          jittered(disk(5), 0.03)};
}

std::vector<Shape> all() {
  std::vector<Shape> shapes = closed();
  for (Shape& shape : withBoundary()) shapes.push_back(std::move(shape));
  return shapes;
}

}  // namespace hgp::test
