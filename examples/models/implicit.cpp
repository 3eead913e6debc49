#include "implicit.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "vectors.h"

namespace hgp::models {
namespace {

using Quad = std::array<int, 4>;

/// Whether each voxel is inside, with one layer of outside voxels all around.
class Voxels {
 public:
  Voxels(const Field& field, double halfSize, int cells)
      : n_(cells), size_(2 * halfSize / cells), low_(-halfSize) {
    value_.resize(static_cast<std::size_t>(n_) * n_ * n_);
    for (int z = 0; z < n_; ++z) {
      for (int y = 0; y < n_; ++y) {
        for (int x = 0; x < n_; ++x) {
          const bool isRim = std::min({x, y, z}) == 0 || std::max({x, y, z}) == n_ - 1;
          value_[index(x, y, z)] = isRim ? 1e30 : field(at(x + 0.5, y + 0.5, z + 0.5));
        }
      }
    }
  }

  int size() const { return n_; }
  double step() const { return size_; }
  Vec3 at(double x, double y, double z) const {
    return {low_ + x * size_, low_ + y * size_, low_ + z * size_};
  }
  bool isInside(int x, int y, int z) const { return value_[index(x, y, z)] < 0; }

  /// Fills voxels until no two of them, inside or outside, touch only in an edge or a corner: the boundary
  /// is a manifold if and only if both are connected through faces around every grid corner.
  void makeManifold() {
    for (bool isDone = false; !isDone;) {
      isDone = true;
      for (int z = 1; z < n_; ++z) {
        for (int y = 1; y < n_; ++y) {
          for (int x = 1; x < n_; ++x) isDone = repairCorner(x, y, z) && isDone;
        }
      }
    }
  }

 private:
  std::size_t index(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * n_ + y) * n_ + x;
  }

  static bool isConnected(unsigned mask) {
    unsigned reached = mask & (~mask + 1);
    for (unsigned before = 0; before != reached;) {
      before = reached;
      for (unsigned i = 0; i < 8; ++i) {
        if (!(reached >> i & 1)) continue;
        for (unsigned axis = 1; axis < 8; axis *= 2) reached |= (1u << (i ^ axis)) & mask;
      }
    }
    return reached == mask;
  }

  bool repairCorner(int x, int y, int z) {
    unsigned inside = 0;
    for (unsigned i = 0; i < 8; ++i) {
      const double value = value_[voxelAround(x, y, z, i)];
      inside |= static_cast<unsigned>(value < 0) << i;
    }
    if (isConnected(inside) && isConnected(~inside & 255u)) return true;
    std::size_t nearest = 0;
    double least = 1e300;
    for (unsigned i = 0; i < 8; ++i) {
      const std::size_t voxel = voxelAround(x, y, z, i);
      if (inside >> i & 1 || value_[voxel] >= least) continue;
      least = value_[voxel];
      nearest = voxel;
    }
    value_[nearest] = -1e-9;
    return false;
  }
  std::size_t voxelAround(int x, int y, int z, unsigned i) const {
    return index(x - 1 + static_cast<int>(i & 1), y - 1 + static_cast<int>(i >> 1 & 1),
                 z - 1 + static_cast<int>(i >> 2));
  }

  int n_;
  double size_, low_;
  std::vector<double> value_;
};

/// The squares between inside and outside voxels, counterclockwise from outside.
class BoundarySquares {
 public:
  explicit BoundarySquares(const Voxels& voxels) : voxels_(voxels) {
    const int n = voxels.size();
    for (int z = 1; z < n; ++z) {
      for (int y = 1; y < n; ++y) {
        for (int x = 1; x < n; ++x) {
          for (int axis = 0; axis < 3; ++axis) addBetween({x, y, z}, axis);
        }
      }
    }
  }
  std::vector<Vec3> positions;
  std::vector<Quad> quads;

 private:
  void addBetween(std::array<int, 3> high, int axis) {
    std::array<int, 3> low = high;
    --low[axis];
    const bool isHigh = voxels_.isInside(high[0], high[1], high[2]);
    if (isHigh == voxels_.isInside(low[0], low[1], low[2])) return;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    Quad quad;
    for (int i = 0; i < 4; ++i) {
      std::array<int, 3> corner = high;
      corner[u] += i == 1 || i == 2;
      corner[v] += i >= 2;
      quad[i] = vertex(corner);
    }
    if (isHigh) std::reverse(quad.begin(), quad.end());
    quads.push_back(quad);
  }
  int vertex(const std::array<int, 3>& corner) {
    const auto [place, isNew] = ids_.try_emplace(corner, static_cast<int>(positions.size()));
    if (isNew) positions.push_back(voxels_.at(corner[0], corner[1], corner[2]));
    return place->second;
  }

  const Voxels& voxels_;
  std::map<std::array<int, 3>, int> ids_;
};

void keepLargestPiece(std::vector<Vec3>& positions, std::vector<Quad>& quads) {
  std::vector<int> root(positions.size());
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](int v) {
    while (root[v] != v) v = root[v] = root[root[v]];
    return v;
  };
  for (const Quad& q : quads) {
    for (int i = 1; i < 4; ++i) root[find(q[i])] = find(q[0]);
  }
  std::map<int, int> count;
  for (const Quad& q : quads) ++count[find(q[0])];
  const int kept = std::max_element(count.begin(), count.end(), [](auto& a, auto& b) {
                     return a.second < b.second;
                   })->first;
  std::erase_if(quads, [&](const Quad& q) { return find(q[0]) != kept; });
  std::vector<int> image(positions.size(), -1);
  std::vector<Vec3> used;
  for (Quad& q : quads) {
    for (int& v : q) {
      if (image[v] < 0) {
        image[v] = static_cast<int>(used.size());
        used.push_back(positions[v]);
      }
      v = image[v];
    }
  }
  positions = std::move(used);
}

void smooth(std::vector<Vec3>& positions, const std::vector<Quad>& quads) {
  std::vector<Vec3> sum(positions.size(), Vec3{0, 0, 0});
  std::vector<int> count(positions.size(), 0);
  for (const Quad& q : quads) {
    for (int i = 0; i < 4; ++i) {
      sum[q[i]] = sum[q[i]] + positions[q[(i + 1) % 4]];
      ++count[q[i]];
    }
  }
  for (std::size_t v = 0; v < positions.size(); ++v) {
    positions[v] = 0.4 * positions[v] + (0.6 / count[v]) * sum[v];
  }
}

}  // namespace

void project(MeshData& mesh, const Field& field, double reach) {
  const double h = 1e-4;
  for (Vec3& p : mesh.positions) {
    const double value = field(p);
    Vec3 gradient;
    for (int i = 0; i < 3; ++i) {
      Vec3 a = p, b = p;
      a[i] -= h;
      b[i] += h;
      gradient[i] = (field(b) - field(a)) / (2 * h);
    }
    const double square = dot(gradient, gradient);
    if (square < 1e-12) continue;
    const double length = std::abs(value) / std::sqrt(square);
    p = p - (value / square * std::min(1.0, reach / std::max(length, 1e-30))) * gradient;
  }
}

MeshData surfaceOf(const Field& field, double halfSize, int cells) {
  Voxels voxels(field, halfSize, cells);
  voxels.makeManifold();
  BoundarySquares squares(voxels);
  keepLargestPiece(squares.positions, squares.quads);
  MeshData mesh;
  for (int pass = 0; pass < 12; ++pass) {
    smooth(squares.positions, squares.quads);
    mesh.positions = std::move(squares.positions);
    project(mesh, field, 0.5 * voxels.step());
    squares.positions = std::move(mesh.positions);
  }
  mesh.positions = std::move(squares.positions);
  for (const Quad& q : squares.quads) {
    const auto diagonal = [&](int i) {
      const Vec3 d = mesh.positions[q[i]] - mesh.positions[q[i + 2]];
      return dot(d, d);
    };
    const int i = diagonal(0) <= diagonal(1) ? 0 : 1;
    mesh.triangles.push_back({q[i], q[i + 1], q[i + 2]});
    mesh.triangles.push_back({q[i], q[i + 2], q[(i + 3) % 4]});
  }
  return mesh;
}

MeshData subdivide(const MeshData& mesh) {
  MeshData fine;
  fine.positions = mesh.positions;
  std::map<std::pair<int, int>, int> middle;
  for (const auto& t : mesh.triangles) {
    std::array<int, 3> m;
    for (int i = 0; i < 3; ++i) {
      const int a = t[i], b = t[(i + 1) % 3];
      const auto [place, isNew] = middle.try_emplace({std::min(a, b), std::max(a, b)},
                                                     static_cast<int>(fine.positions.size()));
      if (isNew) fine.positions.push_back(0.5 * (mesh.positions[a] + mesh.positions[b]));
      m[i] = place->second;
    }
    fine.triangles.push_back({m[0], m[1], m[2]});
    for (int i = 0; i < 3; ++i) fine.triangles.push_back({t[i], m[i], m[(i + 2) % 3]});
  }
  return fine;
}

}  // namespace hgp::models
