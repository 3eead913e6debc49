#include "hgp/features/index_graph.h"

#include <algorithm>
#include <cmath>

namespace hgp {

IndexGraph::IndexGraph(const TriMesh& mesh, const Geometry& geometry, const AlignedField& field)
    : mesh_(mesh), field_(field), sectorsAt_(at(mesh.vertexCount())) {
  angle_.assign(at(mesh.vertexCount()) + field.sectors.list.size(), 0.0);
  for (HalfedgeId h : mesh.halfedges())
    angle_[at(field.sectors.node(mesh, h))] += geometry.cornerAngle[h];
  for (std::size_t s = 0; s < field.sectors.list.size(); ++s)
    sectorsAt_[mesh.tail(field.sectors.list[s].first)].push_back(mesh.vertexCount() +
                                                                 static_cast<int>(s));
}

bool IndexGraph::exists(int n) const {
  if (n >= mesh_.vertexCount()) return true;
  const VertexId v(n);
  return !mesh_.isIsolated(v) && !field_.sectors.isOnFeature[v];
}

VertexId IndexGraph::vertexOf(int n) const {
  if (n < mesh_.vertexCount()) return VertexId(n);
  return mesh_.tail(field_.sectors.list[at(n - mesh_.vertexCount())].first);
}

double IndexGraph::cost(int n, int value) const {
  const int excess = std::max(lowest(n) - value, value - largest(n));
  if (excess > 0) return kImpossible * excess;
  if (n < mesh_.vertexCount()) return std::abs(value - 4);
  const double miss = value - angle_[at(n)] / (kPi / 2.0);
  return kSectorCost * miss * miss;
}

}  // namespace hgp
