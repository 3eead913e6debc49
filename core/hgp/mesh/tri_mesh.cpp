#include "hgp/mesh/tri_mesh.h"

#include <algorithm>
#include <cstdint>

#include "hgp/mesh/defects.h"

namespace hgp {
namespace {

/// Pairs the two halfedges of every edge by sorting them by their undirected vertex pair.
/// @pre the data is an oriented manifold
PerHalfedge<HalfedgeId> pairTwins(const PerHalfedge<VertexId>& corner, int vertexCount) {
  const int halfedgeCount = corner.size();
  // Counting sort by smaller vertex keeps this linear; each bucket is about a valence long.
  std::vector<int> start(static_cast<std::size_t>(vertexCount) + 1, 0);
  const auto low = [&](int h) {
    return std::min(corner[HalfedgeId(h)].i, corner[TriMesh::next(HalfedgeId(h))].i);
  };
  const auto high = [&](int h) {
    return std::max(corner[HalfedgeId(h)].i, corner[TriMesh::next(HalfedgeId(h))].i);
  };
  for (int h = 0; h < halfedgeCount; ++h) ++start[static_cast<std::size_t>(low(h)) + 1];
  for (std::size_t v = 1; v < start.size(); ++v) start[v] += start[v - 1];
  std::vector<int> bucket(static_cast<std::size_t>(halfedgeCount));
  std::vector<int> fill(start.begin(), start.end() - 1);
  for (int h = 0; h < halfedgeCount; ++h)
    bucket[static_cast<std::size_t>(fill[static_cast<std::size_t>(low(h))]++)] = h;

  PerHalfedge<HalfedgeId> twin(static_cast<std::size_t>(halfedgeCount));
  for (std::size_t v = 0; v + 1 < start.size(); ++v) {
    for (int a = start[v]; a < start[v + 1]; ++a) {
      const HalfedgeId h(bucket[static_cast<std::size_t>(a)]);
      if (twin[h].isValid()) continue;
      for (int b = a + 1; b < start[v + 1]; ++b) {
        const HalfedgeId other(bucket[static_cast<std::size_t>(b)]);
        if (high(h.i) != high(other.i)) continue;
        twin[h] = other;
        twin[other] = h;
        break;
      }
    }
  }
  return twin;
}

}  // namespace

int TriMesh::valence(VertexId v) const {
  int count = 0;
  for ([[maybe_unused]] HalfedgeId h : outgoingHalfedges(*this, v)) ++count;
  return count;
}

Result<TriMesh> buildTriMesh(const MeshData& data, bool allowsZeroArea) {
  if (Status usable = requireUsable(findDefects(data), allowsZeroArea); !usable)
    return std::move(usable).error();
  return buildUsableMesh(data);
}

TriMesh buildUsableMesh(const MeshData& data, std::vector<FaceId> givenFace) {
  TriMesh mesh;
  mesh.givenFace_ = std::move(givenFace);
  const auto faceCount = data.triangles.size();
  mesh.positions_ = PerVertex<Vec3>(data.positions);
  mesh.corner_ = PerHalfedge<VertexId>(3 * faceCount);
  for (std::size_t f = 0; f < faceCount; ++f)
    for (int k = 0; k < 3; ++k)
      mesh.corner_[HalfedgeId(static_cast<int>(3 * f) + k)] =
          VertexId(data.triangles[f][static_cast<std::size_t>(k)]);
  mesh.twin_ = pairTwins(mesh.corner_, static_cast<int>(data.positions.size()));

  mesh.edge_ = PerHalfedge<EdgeId>(3 * faceCount);
  std::vector<HalfedgeId> edgeHalfedge;
  edgeHalfedge.reserve(3 * faceCount / 2 + 1);
  mesh.outgoing_ = PerVertex<HalfedgeId>(data.positions.size());
  mesh.isBoundaryVertex_ = PerVertex<char>(data.positions.size(), 0);
  for (HalfedgeId h : mesh.halfedges()) {
    const HalfedgeId twin = mesh.twin_[h];
    if (twin.isValid() && twin < h) {
      mesh.edge_[h] = mesh.edge_[twin];
    } else {
      mesh.edge_[h] = EdgeId(static_cast<int>(edgeHalfedge.size()));
      edgeHalfedge.push_back(h);
    }
    HalfedgeId& first = mesh.outgoing_[mesh.tail(h)];
    if (!first.isValid() || !twin.isValid()) first = h;
    if (!twin.isValid()) {
      mesh.isBoundaryVertex_[mesh.tail(h)] = 1;
      mesh.isBoundaryVertex_[mesh.head(h)] = 1;
    }
  }
  mesh.edgeHalfedge_ = PerEdge<HalfedgeId>(std::move(edgeHalfedge));
  return mesh;
}

}  // namespace hgp
