#include <algorithm>

#include "hgp/parametrize/strategy/moves/moves.h"

namespace hgp {

std::optional<State> fixLifts(const Problem& problem, const State& state,
                              const std::shared_ptr<const Attempt>& attempt) {
  const bool isSoft = problem.weightings[state.weighting].soft > 0.0;
  if (state.untangling >= 0 || isSoft || state.hard.empty() || !attempt->isFeasible()) return {};
  if (!attempt->certificate.isMeasured) return {};
  PerFace<char> isWrong(static_cast<std::size_t>(problem.mesh.faceCount()), 0);
  for (FaceId f : attempt->certificate.orientation.notPositive) isWrong[f] = 1;
  const std::vector<ConePoint>& cones = problem.setup->field.spec.cones;
  State next = state;
  bool isChanged = false;
  for (const MeasuredCone& wrong : attempt->certificate.angles.wrong) {
    const auto isThis = [&](const ConePoint& c) { return c.vertex == wrong.vertex; };
    const auto cone = std::find_if(cones.begin(), cones.end(), isThis);
    // An angle with the right integer that is merely too inexact has no wrong lift.
    const int off = wrong.measured - wrong.asked;
    bool isPositive = cone != cones.end() && off != 0 && off % problem.setup->seams.q == 0;
    if (!isPositive) continue;
    for (HalfedgeId h : outgoingHalfedges(problem.mesh, wrong.vertex))
      isPositive &= !isWrong[TriMesh::face(h)];
    if (!isPositive) continue;
    if (std::any_of(next.lifts.begin(), next.lifts.end(), isThis)) continue;
    next.lifts.push_back(*cone);
    isChanged = true;
  }
  if (!isChanged) return {};
  next.patch.clear();
  next.from = attempt;
  return next;
}

}  // namespace hgp
