#include <algorithm>

#include "hgp/mesh/face_rings.h"
#include "hgp/parametrize/strategy/moves/moves.h"

namespace hgp {
namespace {

/// More wrong triangles, vertices and loops than this share of F_cb: with the connection's frames there is hardly ever a
/// harmonic map.
constexpr double kLargestWrongShare = 0.2;
/// Maximum multiply-adds per iteration and triangle of the mesh, of a dense program with so many constraints.
constexpr double kLargestConicWork = 1e4;

/// Only harmonic maps with a HarmonicBasis can be constrained.
bool isOverBasis(const Problem& problem, const State& state) {
  const Weighting& weighting = problem.weightings[state.weighting];
  return weighting.isHarmonic && weighting.quality == 0.0;
}

bool isAffordable(const Problem& problem, std::size_t constraints) {
  const double unknowns = problem.harmonicCount;
  return 6.0 * static_cast<double>(constraints) * unknowns * unknowns <=
         kLargestConicWork * problem.mesh.faceCount();
}

/// The part of F_cb around what is wrong, without which the map is nearer to the one of least distortion, and faster to
/// solve for, than with all of F_cb; empty where that costs too much.
std::vector<FaceId> constrainedFaces(const Problem& problem, const Attempt& attempt) {
  const std::vector<FaceId> grown = growFaces(problem.mesh, attempt.wrong, 1);
  std::vector<FaceId> faces;
  std::set_intersection(problem.base.begin(), problem.base.end(), grown.begin(), grown.end(),
                        std::back_inserter(faces));
  if (!isAffordable(problem, faces.size())) faces.clear();
  return faces;
}

}  // namespace

std::optional<State> constrainHarmonic(const Problem& problem, const State& state,
                                       const std::shared_ptr<const Attempt>& attempt) {
  if (!isOverBasis(problem, state) || attempt->program.x.size() == 0) return {};
  State next = state;
  next.from = attempt;
  if (state.hard.empty()) {
    if (attempt->wrongCount > kLargestWrongShare * static_cast<double>(problem.base.size()))
      return {};
    next.hard = constrainedFaces(problem, *attempt);
  } else {  // constrained where the map was wrong, and now wrong elsewhere
    if (!attempt->isFeasible() || state.hard.size() == problem.base.size()) return {};
    const std::vector<FaceId> more = constrainedFaces(problem, *attempt);
    next.hard.clear();
    std::set_union(state.hard.begin(), state.hard.end(), more.begin(), more.end(),
                   std::back_inserter(next.hard));
    if (!isAffordable(problem, next.hard.size())) return {};
  }
  if (next.hard.size() == state.hard.size()) return {};
  return next;
}

std::optional<State> harmonicByAngles(const Problem& problem, const State& state,
                                      const std::shared_ptr<const Attempt>& attempt) {
  if (!isOverBasis(problem, state) || attempt->program.x.size() == 0) return {};
  if (problem.hasGivenFrames) return {};
  if (state.framedBy != FramedBy::kConnection || !isAffordable(problem, problem.base.size()))
    return {};
  State next = startOf(problem, state.weighting);
  next.hard = problem.base;
  next.frames = problem.angles->get(problem.mesh, *problem.setup);
  if (!next.frames) return {};
  next.framedBy = FramedBy::kAngles;
  next.from = attempt;
  return next;
}

}  // namespace hgp
