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

std::vector<int> givenIndices(const TriMesh& mesh, const Topology& topology, const Sectors& sectors,
                              const HolonomySpec& asked) {
  if (asked.cones.empty() && asked.corners.empty()) return {};
  std::vector<int> given(at(mesh.vertexCount()) + sectors.list.size(), 0);
  for (VertexId v : mesh.vertices())
    if (!mesh.isIsolated(v) && !sectors.isOnFeature[v]) given[at(v.i)] = asked.q;
  for (const ConePoint& cone : asked.cones)
    if (!sectors.isOnFeature[cone.vertex]) given[at(cone.vertex.i)] = cone.k;

  PerVertex<int> corner(at(mesh.vertexCount()), 0);
  for (const ConePoint& c : asked.corners) corner[c.vertex] = c.k;
  PerVertex<int> sectorsAt(at(mesh.vertexCount()), 0);
  for (const Sector& s : sectors.list) ++sectorsAt[mesh.tail(s.first)];
  for (const BoundaryLoop& loop : topology.loops) {
    const auto hasCorner = [&](HalfedgeId h) { return corner[mesh.tail(h)] != 0; };
    if (std::none_of(loop.halfedges.begin(), loop.halfedges.end(), hasCorner)) continue;
    for (HalfedgeId h : loop.halfedges) {
      const VertexId v = mesh.tail(h);
      if (sectorsAt[v] == 1)
        given[at(sectors.node(mesh, h))] = corner[v] != 0 ? corner[v] : asked.q / 2;
    }
  }
  return given;
}

bool hasGivenIndices(const AlignedField& aligned) {
  for (std::size_t n = 0; n < aligned.given.size(); ++n)
    if (aligned.given[n] != 0 && aligned.given[n] != aligned.index[n]) return false;
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
