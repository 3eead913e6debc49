#include "hgp/quads/quad_shapes.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "hgp/base/check.h"
#include "hgp/mesh/unit_scale.h"
#include "hgp/mesh/vectors.h"

namespace hgp {

double scaledJacobian(const QuadMesh& mesh, int quad) {
  const auto& q = mesh.quads[at(quad)];
  if (std::set<int>(q.begin(), q.end()).size() < 4) return 1.0;
  const auto p = [&](std::size_t k) -> const Vec3& { return mesh.positions[at(q[k % 4])]; };
  const double unit = unitScale(std::max(distance(p(0), p(2)), distance(p(1), p(3))));
  const auto way = [&](std::size_t from, std::size_t to) {
    return scaled(subtract(p(to), p(from)), unit);
  };
  const Vec3 n = cross(way(0, 2), way(1, 3));
  const double length = norm(n);
  double least = 1.0;
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec3 next = way(k, k + 1), previous = way(k, k + 3);
    const double corner = dot(cross(next, previous), n);
    if (!(corner > 0.0) && !(least < 0.0)) least = 0.0;
    const double sides = norm(next) * norm(previous) * length;
    if (sides > 0.0) least = std::min(least, corner / sides);
  }
  return least;
}

int countFoldedInSpace(const QuadMesh& mesh) {
  int count = 0;
  for (std::size_t n = 0; n < mesh.quads.size(); ++n)
    count += !(scaledJacobian(mesh, static_cast<int>(n)) > 0.0);
  return count;
}

}  // namespace hgp
