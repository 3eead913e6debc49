#include "hgp/mesh/surface_order.h"

#include <utility>

#include "hgp/mesh/vectors.h"

namespace hgp {
namespace {

/// Of equal ones that with the smaller (tail, head); both halfedges of an edge have the same length to the last bit.
HalfedgeId longestHalfedge(const TriMesh& mesh) {
  const auto endsOf = [&](HalfedgeId h) {
    return std::pair(mesh.position(mesh.tail(h)), mesh.position(mesh.head(h)));
  };
  HalfedgeId best;
  double longest = -1.0;
  for (HalfedgeId h : mesh.halfedges()) {
    const Vec3 edge = subtract(mesh.position(mesh.head(h)), mesh.position(mesh.tail(h)));
    const double square = dot(edge, edge);
    if (square < longest || (square == longest && endsOf(best) <= endsOf(h))) continue;
    longest = square;
    best = h;
  }
  return best;
}

}  // namespace

std::vector<HalfedgeId> surfaceOrder(const TriMesh& mesh) {
  std::vector<HalfedgeId> order;
  order.reserve(static_cast<std::size_t>(mesh.faceCount()));
  PerFace<char> isTaken(static_cast<std::size_t>(mesh.faceCount()), 0);
  const auto take = [&](HalfedgeId h) {
    char& taken = isTaken[TriMesh::face(h)];
    if (!taken) order.push_back(h);
    taken = 1;
  };
  std::size_t next = 0;
  const auto finishComponent = [&] {
    for (; next < order.size(); ++next) {
      HalfedgeId h = order[next];
      for (int k = 0; k < 3; ++k, h = TriMesh::next(h))
        if (!mesh.isBoundary(h)) take(mesh.twin(h));
    }
  };
  if (mesh.faceCount() > 0) take(longestHalfedge(mesh));
  finishComponent();
  for (int n = 0; n < mesh.faceCount(); ++n) {
    take(TriMesh::halfedge(mesh.givenFace(n), 0));
    finishComponent();
  }
  return order;
}

}  // namespace hgp
