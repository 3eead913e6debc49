#include "unfold.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hgp::bench {
namespace {

/// A triangle's angle at the tail of h.
double angleAt(const PerHalfedge<double>& length, HalfedgeId h) {
  const double a = length[TriMesh::next(h)], b = length[h], c = length[TriMesh::previous(h)];
  const double left = std::max(0.0, (a - b + c) * (a + b - c));
  return 2.0 * std::atan2(std::sqrt(left), std::sqrt((a + b + c) * std::max(0.0, b + c - a)));
}

}  // namespace

std::vector<Complex> unfold(const TriMesh& mesh, const CutMesh& cut,
                            const PerHalfedge<double>& length) {
  const auto n = static_cast<std::size_t>(cut.vertexCount());
  std::vector<Complex> z(n);
  std::vector<char> isPlaced(n, 0);
  PerHalfedge<double> direction(static_cast<std::size_t>(mesh.halfedgeCount()), 0.0);
  PerFace<char> isSeen(static_cast<std::size_t>(mesh.faceCount()), 0);
  const auto copyAt = [&](HalfedgeId h) { return static_cast<std::size_t>(cut.copy[h].i); };
  std::vector<FaceId> queue;
  queue.reserve(static_cast<std::size_t>(mesh.faceCount()));
  // Directions are sums of angles and positions are sums of edges: if they were computed from differences of positions,
  // every thin triangle would amplify errors.
  const auto lay = [&](HalfedgeId h, double towards) {
    const FaceId f = TriMesh::face(h);
    if (isSeen[f]) return;
    isSeen[f] = 1;
    queue.push_back(f);
    const HalfedgeId b = TriMesh::next(h), c = TriMesh::previous(h);
    direction[h] = towards;
    direction[b] = towards + kPi - angleAt(length, b);
    direction[c] = towards + kPi + angleAt(length, h);
    if (!isPlaced[copyAt(c)]) z[copyAt(c)] = z[copyAt(h)] - std::polar(length[c], direction[c]);
    isPlaced[copyAt(c)] = 1;
  };
  const HalfedgeId first = TriMesh::halfedge(FaceId(0), 0);
  z[copyAt(TriMesh::next(first))] = length[first];
  isPlaced[copyAt(first)] = isPlaced[copyAt(TriMesh::next(first))] = 1;
  lay(first, 0.0);
  for (std::size_t i = 0; i < queue.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const HalfedgeId h = TriMesh::halfedge(queue[i], k);
      const HalfedgeId twin = mesh.twin(h);
      if (twin.isValid() && !cut.isSeam[mesh.edge(h)]) lay(twin, direction[h] + kPi);
    }
  return z;
}

}  // namespace hgp::bench
