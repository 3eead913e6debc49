#include "hgp/io/weld.h"

#include <cmath>
#include <cstring>
#include <unordered_map>

#include "hgp/mesh/vectors.h"

namespace hgp::io {
namespace {

std::uint64_t mixed(std::uint64_t h) {
  h ^= h >> 31;
  h *= 0x9e3779b97f4a7c15u;
  return h ^ (h >> 29);
}

std::uint64_t bits(double x) {
  const double plain = x == 0 ? 0.0 : x;
  std::uint64_t b = 0;
  std::memcpy(&b, &plain, sizeof b);
  return b;
}

std::uint64_t hashOf(const Vec3& p) {
  return mixed(mixed(mixed(bits(p[0])) + bits(p[1])) + bits(p[2]));
}

bool isSame(const Vec3& a, const Vec3& b) {
  return bits(a[0]) == bits(b[0]) && bits(a[1]) == bits(b[1]) && bits(a[2]) == bits(b[2]);
}

using Cell = std::array<std::int64_t, 3>;
struct CellHash {
  std::size_t operator()(const Cell& c) const {
    std::uint64_t h = 0;
    for (std::int64_t x : c) h = mixed(h + static_cast<std::uint64_t>(x));
    return static_cast<std::size_t>(h);
  }
};

}  // namespace

Weld weldExact(const std::vector<Vec3>& positions) {
  Weld out;
  out.welded.resize(positions.size());
  std::size_t capacity = 16;
  while (capacity < positions.size() * 2) capacity *= 2;
  std::vector<int> slots(capacity, -1);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    std::size_t s = hashOf(positions[i]) & (capacity - 1);
    while (slots[s] >= 0 &&
           !isSame(out.positions[static_cast<std::size_t>(slots[s])], positions[i])) {
      s = (s + 1) & (capacity - 1);
    }
    if (slots[s] < 0) {
      slots[s] = static_cast<int>(out.positions.size());
      out.positions.push_back(positions[i]);
      out.firstStored.push_back(static_cast<int>(i));
    }
    out.welded[i] = slots[s];
  }
  return out;
}

Weld weldNear(const std::vector<Vec3>& positions, double tolerance) {
  if (!(tolerance > 0)) return weldExact(positions);
  Weld out;
  out.welded.resize(positions.size());
  std::unordered_map<Cell, std::vector<int>, CellHash> grid;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Vec3& p = positions[i];
    Cell cell{};
    for (std::size_t k = 0; k < 3; ++k) {
      const double c = std::floor(p[k] / tolerance);
      cell[k] = std::abs(c) < 4e18 ? static_cast<std::int64_t>(c) : 0;
    }
    int found = -1;
    for (int n = 0; n < 27 && found < 0; ++n) {
      const auto it =
          grid.find({cell[0] + n % 3 - 1, cell[1] + n / 3 % 3 - 1, cell[2] + n / 9 - 1});
      if (it == grid.end()) continue;
      for (int j : it->second) {
        const Vec3& r = out.positions[static_cast<std::size_t>(j)];
        const double d = distance(p, r);
        if (d <= tolerance) {
          found = j;
          break;
        }
      }
    }
    if (found < 0) {
      found = static_cast<int>(out.positions.size());
      out.positions.push_back(p);
      out.firstStored.push_back(static_cast<int>(i));
      grid[cell].push_back(found);
    }
    out.welded[i] = found;
  }
  return out;
}

void joinEqualCopies(const MeshData& mesh, UvMap& map) {
  std::vector<int> head(mesh.positions.size(), -1), next, kept(map.uv.size(), -1);
  std::vector<Vec2> uv;
  for (std::size_t t = 0; t < map.cornerUv.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      int& corner = map.cornerUv[t][k];
      const auto old = static_cast<std::size_t>(corner);
      int& first = head[static_cast<std::size_t>(mesh.triangles[t][k])];
      for (int c = first; kept[old] < 0 && c >= 0; c = next[static_cast<std::size_t>(c)]) {
        if (uv[static_cast<std::size_t>(c)] == map.uv[old]) kept[old] = c;
      }
      if (kept[old] < 0) {
        kept[old] = static_cast<int>(uv.size());
        uv.push_back(map.uv[old]);
        next.push_back(first);
        first = kept[old];
      }
      corner = kept[old];
    }
  }
  map.uv = std::move(uv);
}

}  // namespace hgp::io
