#include "support/maps.h"

#include <cmath>
#include <map>
#include <queue>

#include "hgp/base/turns.h"

namespace hgp::test {
namespace {

Fan fanOf(int n, const std::vector<Vec2>& spokes) {
  MeshData data;
  data.positions.push_back({0, 0, 1});
  for (int i = 0; i < n; ++i)
    data.positions.push_back({std::cos(2 * kPi * i / n), std::sin(2 * kPi * i / n), 0});
  for (int i = 0; i < n; ++i) data.triangles.push_back({0, 1 + i, 1 + (i + 1) % n});
  Fan fan{meshOf(data), {}};
  std::vector<Vec2> corners;
  for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
    corners.push_back({0, 0});
    corners.push_back(spokes[i]);
    corners.push_back(spokes[i + 1]);
  }
  fan.map = mapOfCorners(fan.mesh, corners);
  return fan;
}

}  // namespace

UvMap mapOfCorners(const TriMesh& mesh, const std::vector<Vec2>& cornerUv) {
  UvMap map;
  std::map<std::pair<int, Vec2>, int> copies;
  for (FaceId f : mesh.faces()) {
    std::array<int, 3> t{};
    for (int k = 0; k < 3; ++k) {
      const HalfedgeId h = TriMesh::halfedge(f, k);
      const Vec2 p = cornerUv[static_cast<std::size_t>(h.i)];
      const auto [it, isNew] =
          copies.try_emplace({mesh.tail(h).i, p}, static_cast<int>(map.uv.size()));
      if (isNew) map.uv.push_back(p);
      t[static_cast<std::size_t>(k)] = it->second;
    }
    map.cornerUv.push_back(t);
  }
  return map;
}

UvMap planarMap(const TriMesh& mesh) {
  UvMap map;
  for (VertexId v : mesh.vertices()) map.uv.push_back({mesh.position(v)[0], mesh.position(v)[1]});
  for (FaceId f : mesh.faces()) {
    const auto t = mesh.corners(f);
    map.cornerUv.push_back({t[0].i, t[1].i, t[2].i});
  }
  return map;
}

UvMap developedMap(const TriMesh& mesh, FaceId root) {
  // Position of the third corner relative to the side before it: rational in the coordinates.
  const auto apex = [&](HalfedgeId h) {
    const Vec3 &a = mesh.position(mesh.tail(h)), &b = mesh.position(mesh.head(h)),
               &c = mesh.position(mesh.tail(TriMesh::previous(h)));
    Vec3 ab, ac;
    for (std::size_t n = 0; n < 3; ++n) {
      ab[n] = b[n] - a[n];
      ac[n] = c[n] - a[n];
    }
    const Vec3 x{ab[1] * ac[2] - ab[2] * ac[1], ab[2] * ac[0] - ab[0] * ac[2],
                 ab[0] * ac[1] - ab[1] * ac[0]};
    const double square = ab[0] * ab[0] + ab[1] * ab[1] + ab[2] * ab[2];
    const double dot = ab[0] * ac[0] + ab[1] * ac[1] + ab[2] * ac[2];
    return Complex(dot / square, std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]) / square);
  };
  std::vector<Complex> z(static_cast<std::size_t>(mesh.halfedgeCount()));
  const auto at = [&](HalfedgeId h) -> Complex& { return z[static_cast<std::size_t>(h.i)]; };
  std::vector<char> isPlaced(static_cast<std::size_t>(mesh.faceCount()), 0);
  const auto place = [&](HalfedgeId h, Complex tail, Complex head) {
    at(h) = tail;
    at(TriMesh::next(h)) = head;
    at(TriMesh::previous(h)) = tail + apex(h) * (head - tail);
    isPlaced[static_cast<std::size_t>(TriMesh::face(h).i)] = 1;
  };
  std::queue<FaceId> queue;
  place(TriMesh::halfedge(root, 0), 0.0, 1.0);
  queue.push(root);
  while (!queue.empty()) {
    const FaceId f = queue.front();
    queue.pop();
    for (int k = 0; k < 3; ++k) {
      const HalfedgeId h = TriMesh::halfedge(f, k), twin = mesh.twin(h);
      if (!twin.isValid() || isPlaced[static_cast<std::size_t>(TriMesh::face(twin).i)]) continue;
      place(twin, at(TriMesh::next(h)), at(h));
      queue.push(TriMesh::face(twin));
    }
  }
  std::vector<Vec2> corners;
  for (Complex p : z) corners.push_back({p.real(), p.imag()});
  return mapOfCorners(mesh, corners);
}

UvMap flatTorusMap(int m, int n) {
  std::vector<Vec2> corners;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < m; ++i)
      for (const auto& [di, dj] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}})
        corners.push_back({double(i + di), double(j + dj)});
  return mapOfCorners(torus(m, n).mesh(), corners);
}

Fan fan(int n, double angle) {
  std::vector<Vec2> spokes;
  for (int i = 0; i <= n; ++i) spokes.push_back({std::cos(angle * i / n), std::sin(angle * i / n)});
  return fanOf(n, spokes);
}

Fan quarterFan(int n) {
  std::vector<Vec2> spokes;
  for (int i = 0; i <= n; ++i) {
    const Complex d = rotation(i, 4);
    spokes.push_back({d.real(), d.imag()});
  }
  return fanOf(n, spokes);
}

}  // namespace hgp::test
