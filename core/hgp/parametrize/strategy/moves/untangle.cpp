#include "hgp/parametrize/strategy/moves/moves.h"

namespace hgp {
namespace {

/// Maximum of Newton steps × triangles in a run: about half a minute.
constexpr double kMaxFaceSteps = 1.2e7;
/// Maximum number of steps of one kind of untangling, which starts only if the remaining work allows as many.
constexpr int kMaxStepsOfKind = 220;
/// Maximum number of triangles: the limits above hold only after a whole kind, and at 595 000 triangles 20 minutes were not
/// enough.
constexpr int kMaxTriangles = 200'000;

}  // namespace

std::optional<State> untangleNext(const Problem& problem, const State& state,
                                  const std::shared_ptr<const Attempt>& attempt) {
  // Tried after the first weighting with hard constraints and before later weightings.
  const Weighting& weighting = problem.weightings[state.weighting];
  if (problem.method != Method::kAuto || weighting.soft > 0.0 || weighting.isHarmonic) return {};
  if (problem.mesh.faceCount() > kMaxTriangles) return {};
  auto next = static_cast<std::size_t>(state.untangling + 1);
  std::shared_ptr<const SeamRotations> frames;
  for (; next < untanglings().size(); ++next) {
    if (untanglings()[next].framedBy == FramedBy::kConnection) break;
    frames = problem.angles->get(problem.mesh, *problem.setup);
    if (frames) break;
  }
  if (next >= untanglings().size()) return {};
  const bool isFirst = state.untangling < 0;
  if (isFirst && state.untangled > 0) return {};
  if (static_cast<double>(kMaxStepsOfKind) * problem.mesh.faceCount() > problem.maxFaceSteps)
    return {};
  const int spent = state.untangled + (isFirst ? 0 : attempt->program.iterations);
  if (static_cast<double>(spent) * problem.mesh.faceCount() > kMaxFaceSteps) return {};
  State out = startOf(problem, state.weighting);
  out.untangling = static_cast<int>(next);
  out.untangled = spent;
  out.hard.clear();
  out.framedBy = untanglings()[next].framedBy;
  out.frames = std::move(frames);
  out.from = state.from;
  if (!isFirst && out.untangled == 0) out.untangled = 1;
  return out;
}

}  // namespace hgp
