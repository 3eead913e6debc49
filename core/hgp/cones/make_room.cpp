#include "hgp/cones/make_room.h"

#include <algorithm>

namespace hgp {
namespace {

/// Interior vertices at 2 … kReceivers edges from v: those beside it share its triangles.
std::vector<VertexId> aroundBeyondTheRing(const TriMesh& mesh, VertexId v) {
  std::vector<VertexId> all{v}, found;
  std::size_t start = 0;
  for (int ring = 1; ring <= kReceivers; ++ring) {
    const std::size_t end = all.size();
    for (; start < end; ++start)
      for (HalfedgeId h : outgoingHalfedges(mesh, all[start])) {
        const VertexId u = mesh.head(h);
        if (std::find(all.begin(), all.end(), u) != all.end()) continue;
        all.push_back(u);
        if (ring > 1 && !mesh.isBoundary(u)) found.push_back(u);
      }
  }
  return found;
}

}  // namespace

void makeRoom(const TriMesh& mesh, HolonomySpec& spec, AngleShortageMemo& shortages) {
  PerVertex<int> k(static_cast<std::size_t>(mesh.vertexCount()), spec.q);
  for (const ConePoint& cone : spec.cones) k[cone.vertex] = cone.k;
  bool isChanged = false;
  for (int unit = 0; unit < kMaxUnits; ++unit) {
    const std::optional<AngleShortage>& shortage = shortages.find(mesh, spec.q, k);
    if (!shortage || shortage->cones.empty()) break;
    const VertexId giver = shortage->cones.front();
    const std::vector<VertexId> near = aroundBeyondTheRing(mesh, giver);
    const auto steepness = [&](VertexId v) {
      return static_cast<double>(k[v] + 1) / mesh.valence(v);
    };
    const auto receiver = std::min_element(near.begin(), near.end(), [&](VertexId a, VertexId b) {
      return steepness(a) < steepness(b);
    });
    if (receiver == near.end() || k[giver] < 2) break;
    --k[giver];
    ++k[*receiver];
    isChanged = true;
  }
  if (!isChanged) return;
  spec.cones.clear();
  for (VertexId v : mesh.vertices())
    if (k[v] != spec.q) spec.cones.push_back({v, k[v]});
}

}  // namespace hgp
