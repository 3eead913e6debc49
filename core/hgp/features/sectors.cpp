#include "hgp/features/sectors.h"

#include "hgp/base/check.h"

namespace hgp {

Sectors findSectors(const TriMesh& mesh, const std::vector<EdgeId>& features) {
  Sectors out;
  out.isFeature = PerEdge<char>(at(mesh.edgeCount()), 0);
  out.isOnFeature = PerVertex<char>(at(mesh.vertexCount()), 0);
  out.of = PerHalfedge<int>(at(mesh.halfedgeCount()), -1);
  for (EdgeId e : features) {
    out.isFeature[e] = 1;
    out.isOnFeature[mesh.tail(mesh.halfedge(e))] = 1;
    out.isOnFeature[mesh.head(mesh.halfedge(e))] = 1;
  }
  for (HalfedgeId h : mesh.halfedges()) {
    HGP_CHECK(out.isFeature[mesh.edge(h)] || !mesh.isBoundary(h), "boundary edges are features");
    if (!out.isFeature[mesh.edge(h)]) continue;
    Sector sector{h, {}, 0};
    for (HalfedgeId corner = h;;) {
      out.of[corner] = static_cast<int>(out.list.size());
      ++sector.triangles;
      sector.last = TriMesh::previous(corner);
      if (out.isFeature[mesh.edge(sector.last)]) break;
      corner = mesh.twin(sector.last);
    }
    out.list.push_back(sector);
  }
  return out;
}

}  // namespace hgp
