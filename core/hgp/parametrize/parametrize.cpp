#include "hgp/parametrize/parametrize.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "hgp/parametrize/repair_plan.h"
#include "hgp/parametrize/seamless_setup.h"
#include "hgp/parametrize/solution.h"
#include "hgp/parametrize/stage_clock.h"

namespace hgp {
namespace {

/// One program, laid out as a map and judged.
struct Attempt {
  ProgramResult program;
  UvMap map;
  Certificate certificate;
};

Attempt solveAndJudge(const TriMesh& mesh, const SeamlessSetup& setup, const Judge& judge,
                      const RepairStep& step, int round, const ParametrizeOptions& options,
                      bool& isCancelled) {
  ProgramOptions program;
  program.u = step.u;
  program.quality = step.quality;
  program.isExact = step.isExact;
  program.pulled = step.pulled;
  program.pull = step.pull;
  program.vertexTree = &setup.context->tree;
  if (step.local) program.local = &*step.local;
  program.progress = [&](int iteration, double residual) {
    const double fraction = 1.0 - 1.0 / (1.0 + 0.25 * iteration);
    isCancelled = !report(options.progress,
                          {"solve", fraction, iteration, residual, round, options.maxRounds});
    return !isCancelled;
  };
  Attempt attempt;
  attempt.program = solveProgram(mesh, setup.context->geometry, setup.cut, setup.seams,
                                 setup.unknowns, setup.harmonic, step.frames, program);
  attempt.map = layOut(mesh, setup, attempt.program.z);
  attempt.certificate = judge.certify(toSpec(setup.field.spec), attempt.map);
  return attempt;
}

Round describe(const Attempt& attempt, const RepairStep& step, double seconds) {
  Round round;
  round.method = step.method;
  round.constrainedTriangles = static_cast<int>(step.frames.faces.size());
  round.iterations = attempt.program.iterations;
  round.solverStatus = socp::statusName(attempt.program.status);
  round.flipped = attempt.certificate.orientation.zero + attempt.certificate.orientation.negative;
  round.wrongAngles = static_cast<int>(attempt.certificate.angles.wrong.size());
  for (const MeasuredTurning& t : attempt.certificate.angles.turnings)
    round.wrongAngles += t.isWrong;
  round.laplacianEnergy = attempt.program.laplacianEnergy;
  round.seconds = seconds;
  return round;
}

/// How far from certified, to keep the best of several maps.
long long distanceToCertified(const Attempt& attempt) {
  const Certificate& c = attempt.certificate;
  if (c.isCertified) return -1;
  if (!c.isMeasured) return 1LL << 40;
  return c.orientation.zero + c.orientation.negative +
         static_cast<long long>(c.angles.wrong.size());
}

void explain(const SeamlessSetup& setup, bool hasGivenFrames, Parametrization& result) {
  const double range = setup.field.scaleRange;
  if (range > kHopelessScaleRange)
    result.notes.push_back("These cones stretch the surface by e^" +
                           std::to_string(static_cast<int>(range)) +
                           ": even a certified map will have areas too small to use. Add cones in "
                           "the regions that shrink.");
  else if (range > kHardScaleRange)
    result.notes.push_back("These cones stretch the surface by e^" +
                           std::to_string(static_cast<int>(range)) +
                           "; expect strong area distortion. More cones lower it.");
  if (!result.conflict.empty())
    result.notes.push_back(
        "No map turns all frames as asked: " + std::to_string(result.conflict.size()) +
        " constrained triangles work against each other (see conflict).");
  if (!result.isCertified && hasGivenFrames)
    result.notes.push_back(
        "The frames were those of the given field, as asked. Automatic frames have the same cones, "
        "turning and handles but turn evenly, and may be certified where these are not.");
}

/// The best of several, with what it was judged by.
struct Judged {
  Solution solution;
  UvMap map;
  Certificate certificate;
};

using Clock = std::chrono::steady_clock;
double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

/// Solve, judge, repair, until certified or out of ideas [BCW17 §7].
static Result<Judged> solve(const TriMesh& mesh, std::shared_ptr<const SeamlessSetup> setup,
                            const ParametrizeOptions& options, Parametrization& result) {
  RepairPlan plan(mesh, *setup, options.useQuality);
  const Judge judge(mesh);
  std::optional<Attempt> best;
  Solution solution;
  for (int round = 1; round <= options.maxRounds; ++round) {
    const std::optional<RepairStep> step = plan.next();
    if (!step) break;
    if (!report(options.progress, {"solve", 0.0, -1, -1.0, round, options.maxRounds}))
      return cancelled("solve");
    const auto roundStart = Clock::now();
    bool isCancelled = false;
    Attempt attempt = solveAndJudge(mesh, *setup, judge, *step, round, options, isCancelled);
    if (isCancelled) return cancelled("solve");
    result.rounds.push_back(describe(attempt, *step, secondsSince(roundStart)));
    plan.learn(attempt.program, attempt.certificate);
    if (!best || distanceToCertified(attempt) < distanceToCertified(*best)) {
      best = std::move(attempt);
      solution = {setup, std::move(best->program.x), step->u, step->frames};
    }
    if (best->certificate.isCertified) break;
  }
  if (!best) return Failure{ErrorCode::kUsage, "solve", "At least one round is needed.", {}};
  if (!best->certificate.isCertified) result.conflict = best->program.conflict;
  return Judged{std::move(solution), std::move(best->map), std::move(best->certificate)};
}

Result<Parametrization> parametrize(PreparedSurface& surface, const HolonomySpec& spec,
                                    const ParametrizeOptions& options) {
  const TriMesh& mesh = surface.mesh();
  Parametrization result;
  Result<SeamlessSetup> prepared = prepareSeamless(surface, spec, options, result.times);
  if (!prepared) return std::move(prepared).error();
  const auto setup = std::make_shared<const SeamlessSetup>(std::move(*prepared));
  result.spec = setup->field.spec;
  result.notes = setup->warnings;

  const auto start = Clock::now();
  Result<Judged> best = solve(mesh, setup, options, result);
  if (!best) return std::move(best).error();
  if (best->certificate.isCertified && finish(mesh, options, best->solution)) {
    best->map = layOut(mesh, best->solution);
    best->certificate = certify(mesh, result.spec, best->map);
  }
  result.times.push_back({"solve", secondsSince(start)});

  result.map = std::move(best->map);
  result.copyOf = setup->cut.parent.raw();
  result.certificate = std::move(best->certificate);
  result.isCertified = result.certificate.isCertified;
  result.isUsable = result.certificate.isUsable;
  explain(*setup, options.frames.has_value(), result);
  return result;
}

Result<Parametrization> parametrize(const TriMesh& mesh, const HolonomySpec& spec,
                                    const ParametrizeOptions& options) {
  std::vector<StageTime> times;
  StageClock clock(options.progress, times);
  if (!clock.begin("prepare")) return cancelled("prepare");
  PreparedSurface surface(mesh);
  clock.end();
  Result<Parametrization> result = parametrize(surface, spec, options);
  if (result) result->times.insert(result->times.begin(), times.begin(), times.end());
  return result;
}

}  // namespace hgp
