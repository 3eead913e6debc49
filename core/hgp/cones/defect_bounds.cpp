#include "hgp/cones/defect_bounds.h"

#include <algorithm>
#include <cmath>

namespace hgp {

DefectBounds defectBounds(const TriMesh& mesh, const FieldContext& context, int q,
                          double largestTurn) {
  DefectBounds b;
  const auto n = static_cast<std::size_t>(context.surface.nodeCount);
  b.low.assign(n, 0);
  b.high.assign(n, 0);
  for (VertexId v : mesh.vertices()) {
    if (!context.surface.isInterior(mesh, v)) continue;
    const auto node = static_cast<std::size_t>(context.surface.node[v]);
    const int valence = mesh.valence(v);
    const int least = q - (q * valence - 1) / 2, most = q - 1;
    const double K = curvature(mesh, context.geometry, v), turn = largestTurn * valence;
    const double unit = turnAngle(1, q);
    b.low[node] = std::clamp(static_cast<int>(std::ceil((K - turn) / unit)), least, most);
    b.high[node] = std::clamp(static_cast<int>(std::floor((K + turn) / unit)), b.low[node], most);
  }
  for (std::size_t j = 0; j < context.topology.loops.size(); ++j) {
    const TurningRange range = turningRange(mesh, context.topology.loops[j], q);
    const auto node = static_cast<std::size_t>(context.surface.loopNode[j]);
    b.low[node] = static_cast<int>(std::max<long long>(q + range.lowest, -1'000'000));
    b.high[node] = static_cast<int>(std::min<long long>(q + range.highest, 1'000'000));
  }
  return b;
}

}  // namespace hgp
