#include "hgp/mesh/refine.h"

#include <algorithm>

namespace hgp {
namespace {

VertexPair pairOf(int a, int b) { return a < b ? VertexPair{a, b} : VertexPair{b, a}; }

double squaredDistance(const Vec3& a, const Vec3& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < 3; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sum;
}

class Splitter {
 public:
  Splitter(const MeshData& before, std::vector<VertexPair> edges) : before_(before) {
    for (VertexPair& e : edges) e = pairOf(e[0], e[1]);
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    edges_ = std::move(edges);
  }

  RefinedMesh run() {
    keepEdgesOfTriangles();
    out_.mesh.positions = before_.positions;
    out_.mesh.positions.reserve(before_.positions.size() + edges_.size());
    for (const VertexPair& e : edges_) {
      const Vec3 &a = position(e[0]), &b = position(e[1]);
      out_.mesh.positions.push_back(
          {0.5 * a[0] + 0.5 * b[0], 0.5 * a[1] + 0.5 * b[1], 0.5 * a[2] + 0.5 * b[2]});
    }
    for (std::size_t f = 0; f < before_.triangles.size(); ++f) divide(static_cast<int>(f));
    out_.parents = std::move(edges_);
    return std::move(out_);
  }

 private:
  const Vec3& position(int v) const { return out_.mesh.positions[static_cast<std::size_t>(v)]; }
  static bool isTriangle(const std::array<int, 3>& t) {
    return t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
  }
  /// −1 where it is not split.
  int indexOf(int a, int b) const {
    const auto it = std::lower_bound(edges_.begin(), edges_.end(), pairOf(a, b));
    return it != edges_.end() && *it == pairOf(a, b) ? static_cast<int>(it - edges_.begin()) : -1;
  }

  void keepEdgesOfTriangles() {
    std::vector<char> isThere(edges_.size(), 0);
    for (const auto& t : before_.triangles) {
      if (!isTriangle(t)) continue;
      for (std::size_t k = 0; k < 3; ++k)
        if (const int e = indexOf(t[k], t[(k + 1) % 3]); e >= 0)
          isThere[static_cast<std::size_t>(e)] = 1;
    }
    std::vector<VertexPair> kept;
    for (std::size_t e = 0; e < edges_.size(); ++e)
      if (isThere[e]) kept.push_back(edges_[e]);
    edges_ = std::move(kept);
  }

  /// Corners 0 to 2 are those of the face, 3 + k the midpoint of side k → k + 1.
  void add(int face, const std::array<int, 6>& vertex, const std::array<int, 3>& corners) {
    std::array<int, 3> triangle{};
    std::array<std::array<int, 2>, 3> origin{};
    for (std::size_t k = 0; k < 3; ++k) {
      const int c = corners[k];
      triangle[k] = vertex[static_cast<std::size_t>(c)];
      origin[k] = c < 3 ? std::array<int, 2>{c, c} : std::array<int, 2>{c - 3, (c - 2) % 3};
    }
    out_.mesh.triangles.push_back(triangle);
    out_.faceOrigin.push_back(face);
    out_.cornerOrigin.push_back(origin);
  }

  void divide(int face) {
    const auto& t = before_.triangles[static_cast<std::size_t>(face)];
    std::array<int, 6> vertex{t[0], t[1], t[2], -1, -1, -1};
    int count = 0;
    for (std::size_t k = 0; k < 3 && isTriangle(t); ++k) {
      const int e = indexOf(t[k], t[(k + 1) % 3]);
      if (e < 0) continue;
      vertex[3 + k] = static_cast<int>(before_.positions.size()) + e;
      ++count;
    }
    if (count == 0) return add(face, vertex, {0, 1, 2});
    if (count == 3) {
      for (int k = 0; k < 3; ++k) add(face, vertex, {k, 3 + k, 3 + (k + 2) % 3});
      return add(face, vertex, {3, 4, 5});
    }
    // Rotates the corners so that the split side (if there is one) or the unsplit side (if two are split) comes first.
    int k = 0;
    while ((vertex[static_cast<std::size_t>(3 + k)] >= 0) != (count == 1)) ++k;
    const int a = k, b = (k + 1) % 3, c = (k + 2) % 3;
    if (count == 1) {
      add(face, vertex, {a, 3 + a, c});
      return add(face, vertex, {3 + a, b, c});
    }
    add(face, vertex, {c, 3 + c, 3 + b});
    const auto at = [&](int corner) { return position(vertex[static_cast<std::size_t>(corner)]); };
    if (squaredDistance(at(a), at(3 + b)) < squaredDistance(at(b), at(3 + c))) {
      add(face, vertex, {a, b, 3 + b});
      add(face, vertex, {a, 3 + b, 3 + c});
    } else {
      add(face, vertex, {a, b, 3 + c});
      add(face, vertex, {b, 3 + b, 3 + c});
    }
  }

  const MeshData& before_;
  std::vector<VertexPair> edges_;
  RefinedMesh out_;
};

}  // namespace

RefinedMesh splitEdges(const MeshData& mesh, std::vector<VertexPair> edges) {
  return Splitter(mesh, std::move(edges)).run();
}

}  // namespace hgp
