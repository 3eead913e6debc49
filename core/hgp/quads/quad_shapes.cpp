#include "hgp/quads/quad_shapes.h"

#include <set>

#include "hgp/base/check.h"
#include "hgp/mesh/vectors.h"

namespace hgp {
namespace {

Vec3 minus(const Vec3& a, const Vec3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vec3 crossed(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dotted(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

bool isFolded(const std::array<Vec3, 4>& p) {
  const Vec3 n = crossed(minus(p[2], p[0]), minus(p[3], p[1]));
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec3 corner = crossed(minus(p[(k + 1) % 4], p[k]), minus(p[(k + 3) % 4], p[k]));
    if (!(dotted(corner, n) > 0.0)) return true;
  }
  return false;
}

}  // namespace

int countFoldedInSpace(const QuadMesh& mesh) {
  int count = 0;
  for (const auto& quad : mesh.quads) {
    if (std::set<int>(quad.begin(), quad.end()).size() < 4) continue;
    std::array<Vec3, 4> p;
    for (std::size_t k = 0; k < 4; ++k) p[k] = mesh.positions[at(quad[k])];
    count += isFolded(p);
  }
  return count;
}

}  // namespace hgp
