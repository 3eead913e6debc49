#include "hgp/parametrize/strategy/frames_of_metric.h"
#include "hgp/parametrize/strategy/moves/moves.h"

namespace hgp {
namespace {

/// Maximum number of corrections in a row; hardly any map needs more than two.
constexpr int kMaxCorrections = 4;
/// An untangled map may be wrong in this share of the triangles: mostly one that is crushed beside a vertex that turns
/// once too often, while a cone turns once too little. The map of a cone program, which other frames may still mend, may
/// be wrong in one triangle and its vertices.
constexpr double kFewWrongShare = 0.01;
constexpr int kFewWrongOfProgram = 4;

}  // namespace

std::optional<State> frameByMap(const Problem& problem, const State& state,
                                const std::shared_ptr<const Attempt>& attempt) {
  if (problem.method != Method::kAuto || !attempt->isFeasible()) return {};
  if (problem.weightings[state.weighting].isHarmonic) return {};
  if (!attempt->certificate.isMeasured) return {};
  const double few =
      state.untangling >= 0 ? kFewWrongShare * problem.mesh.faceCount() : kFewWrongOfProgram;
  const bool isFolded = !attempt->certificate.orientation.notPositive.empty();
  if (isFolded && attempt->wrongCount > few) return {};
  if (attempt->wrongCount == 0 || attempt->program.z.empty() || !attempt->program.x.allFinite())
    return {};
  const bool isBetter = state.corrections == 0 || attempt->wrongCount < state.from->wrongCount;
  if (!isBetter || state.corrections >= kMaxCorrections) return {};
  State next = startOf(problem, state.weighting);
  next.frames = framesOfMap(problem.mesh, *problem.setup, attempt->program.z);
  if (!next.frames) return {};
  next.framedBy = FramedBy::kMap;
  next.corrections = state.corrections + 1;
  next.hard.clear();
  next.untangling = std::max(0, state.untangling);
  next.untangled = state.untangled + (state.untangling >= 0 ? attempt->program.iterations : 0);
  next.from = attempt;
  return next;
}

}  // namespace hgp
