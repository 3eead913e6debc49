#include "hgp/features/aligned_field.h"

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

CompleteSpec specOf(const TriMesh& mesh, const Topology& topology,
                    const std::vector<DualLoop>& handles, const AlignedField& aligned,
                    const std::vector<EdgeId>& features) {
  CompleteSpec spec;
  spec.q = aligned.field.q;
  spec.features = features;
  const Sectors& sectors = aligned.sectors;
  for (VertexId v : mesh.vertices()) {
    if (mesh.isIsolated(v) || mesh.isBoundary(v)) continue;
    int k = aligned.index[at(v.i)];
    if (sectors.isOnFeature[v]) {
      k = 0;
      for (HalfedgeId h : outgoingHalfedges(mesh, v))
        if (sectors.isFeature[mesh.edge(h)]) k += aligned.index[at(sectors.node(mesh, h))];
    }
    if (k != spec.q) spec.cones.push_back({v, k});
  }
  for (const BoundaryLoop& loop : topology.loops) {
    int l = 0;
    for (HalfedgeId boundary : loop.halfedges) {
      l += 2;
      for (HalfedgeId h : outgoingHalfedges(mesh, mesh.tail(boundary)))
        if (sectors.isFeature[mesh.edge(h)]) l -= aligned.index[at(sectors.node(mesh, h))];
    }
    spec.turning.push_back(l);
  }
  for (const DualLoop& loop : handles) spec.handles.push_back(loopHolonomy(aligned.field, loop));
  return spec;
}

}  // namespace hgp
