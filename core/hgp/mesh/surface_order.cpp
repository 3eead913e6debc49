#include "hgp/mesh/surface_order.h"

#include <tuple>

#include "hgp/mesh/vectors.h"

namespace hgp {
namespace {

/// Compares (squared length, tail, head); both halfedges of an edge have the same length to the last bit.
HalfedgeId longestHalfedge(const TriMesh& mesh) {
  const auto keyOf = [&](HalfedgeId h) {
    const Vec3 &tail = mesh.position(mesh.tail(h)), &head = mesh.position(mesh.head(h));
    const Vec3 edge = subtract(head, tail);
    return std::make_tuple(-dot(edge, edge), tail, head);
  };
  HalfedgeId best;
  for (HalfedgeId h : mesh.halfedges())
    if (!best.isValid() || keyOf(h) < keyOf(best)) best = h;
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
