#include "hgp/features/aligned_field.h"

#include <algorithm>

namespace hgp {

int largestIndex(const TriMesh& mesh, const Sectors& sectors, int node) {
  if (node < mesh.vertexCount()) return 2 * mesh.valence(VertexId(node)) - 1;
  const Sector& sector = sectors.list[at(node - mesh.vertexCount())];
  int quarters = 0;
  for (HalfedgeId h = sector.first;; h = mesh.twin(TriMesh::previous(h))) {
    const auto isFeature = [&](HalfedgeId side) { return sectors.isFeature[mesh.edge(side)] != 0; };
    const bool isBeside =
        isFeature(TriMesh::next(h)) && (isFeature(h) || isFeature(TriMesh::previous(h)));
    quarters += isBeside ? 1 : 2;
    if (isFeature(TriMesh::previous(h))) break;
  }
  return quarters - 1;
}

GivenIndices givenIndices(const TriMesh& mesh, const Topology& topology, const Sectors& sectors,
                          const HolonomySpec& asked) {
  if (asked.cones.empty() && asked.corners.empty()) return {};
  // Quarter turns of every vertex, 0 on loops without corners.
  PerVertex<int> wanted(at(mesh.vertexCount()), 0);
  for (VertexId v : mesh.vertices())
    if (!mesh.isIsolated(v) && !mesh.isBoundary(v)) wanted[v] = asked.q;
  for (const ConePoint& cone : asked.cones) wanted[cone.vertex] = cone.k;
  for (const ConePoint& corner : asked.corners) wanted[corner.vertex] = corner.k;
  for (const BoundaryLoop& loop : topology.loops) {
    const auto isCorner = [&](HalfedgeId h) { return wanted[mesh.tail(h)] != 0; };
    if (std::none_of(loop.halfedges.begin(), loop.halfedges.end(), isCorner)) continue;
    for (HalfedgeId h : loop.halfedges)
      if (!isCorner(h)) wanted[mesh.tail(h)] = asked.q / 2;
  }

  GivenIndices given;
  given.node.assign(at(mesh.vertexCount()) + sectors.list.size(), 0);
  given.around = PerVertex<int>(at(mesh.vertexCount()), 0);
  PerVertex<int> sectorsAt(at(mesh.vertexCount()), 0);
  for (const Sector& s : sectors.list) ++sectorsAt[mesh.tail(s.first)];
  for (VertexId v : mesh.vertices()) {
    if (!sectors.isOnFeature[v]) given.node[at(v.i)] = wanted[v];
    if (sectorsAt[v] > 1) given.around[v] = wanted[v];
  }
  for (std::size_t s = 0; s < sectors.list.size(); ++s)
    if (const VertexId v = mesh.tail(sectors.list[s].first); sectorsAt[v] == 1)
      given.node[at(mesh.vertexCount()) + s] = wanted[v];
  return given;
}

bool hasGivenIndices(const TriMesh& mesh, const AlignedField& aligned) {
  for (std::size_t n = 0; n < aligned.given.node.size(); ++n)
    if (aligned.given.node[n] != 0 && aligned.given.node[n] != aligned.index[n]) return false;
  for (VertexId v : mesh.vertices())
    if (const int sum = givenAround(aligned, v); sum != 0 && sum != indexAround(mesh, aligned, v))
      return false;
  return true;
}

int indexAround(const TriMesh& mesh, const AlignedField& aligned, VertexId v) {
  const Sectors& sectors = aligned.sectors;
  int k = 0;
  for (HalfedgeId h : outgoingHalfedges(mesh, v))
    if (sectors.isFeature[mesh.edge(h)]) k += aligned.index[at(sectors.node(mesh, h))];
  return k;
}

CompleteSpec specOf(const TriMesh& mesh, const Topology& topology,
                    const std::vector<DualLoop>& handles, const AlignedField& aligned,
                    const std::vector<EdgeId>& features) {
  CompleteSpec spec;
  spec.q = aligned.field.q;
  spec.features = features;
  spec.corners = aligned.corners;
  const Sectors& sectors = aligned.sectors;
  for (VertexId v : mesh.vertices()) {
    if (mesh.isIsolated(v) || mesh.isBoundary(v)) continue;
    const int k = sectors.isOnFeature[v] ? indexAround(mesh, aligned, v) : aligned.index[at(v.i)];
    if (k != spec.q) spec.cones.push_back({v, k});
  }
  for (const BoundaryLoop& loop : topology.loops) {
    int l = 0;
    for (HalfedgeId boundary : loop.halfedges)
      l += 2 - indexAround(mesh, aligned, mesh.tail(boundary));
    spec.turning.push_back(l);
  }
  for (const DualLoop& loop : handles) spec.handles.push_back(loopHolonomy(aligned.field, loop));
  return spec;
}

}  // namespace hgp
