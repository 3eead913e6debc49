#include <algorithm>

#include "hgp/parametrize/moves/moves.h"

namespace hgp {

std::optional<State> embedRings(const Problem& problem, const State& state,
                                const std::shared_ptr<const Attempt>& attempt) {
  if (state.untangling >= 0 || attempt->program.conflict.empty()) return {};
  PerVertex<char> isHit(static_cast<std::size_t>(problem.mesh.vertexCount()), 0);
  for (FaceId f : attempt->program.conflict)
    for (VertexId v : problem.mesh.corners(f)) isHit[v] = 1;
  for (const ConePoint& cone : state.rings) isHit[cone.vertex] = 0;
  for (VertexId v : state.takenBack) isHit[v] = 0;
  State next = state;
  for (const ConePoint& cone : problem.setup->field.spec.cones)
    if (isHit[cone.vertex]) next.rings.push_back(cone);
  if (next.rings.size() == state.rings.size()) return {};
  next.growth = 0;
  next.patch.clear();
  next.hard = problem.base;
  return next;
}

}  // namespace hgp
