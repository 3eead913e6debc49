#include "hgp/parametrize/parametrize.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "hgp/field/prescribed_field.h"
#include "hgp/parametrize/repair_plan.h"
#include "hgp/parametrize/seamless_setup.h"
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
  program.vertexTree = &setup.context.tree;
  if (step.local) program.local = &*step.local;
  program.progress = [&](int iteration, double residual) {
    const double fraction = 1.0 - 1.0 / (1.0 + 0.25 * iteration);
    isCancelled = !report(options.progress,
                          {"solve", fraction, iteration, residual, round, options.maxRounds});
    return !isCancelled;
  };
  Attempt attempt;
  attempt.program = solveProgram(mesh, setup.context.geometry, setup.cut, setup.seams,
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
  if (result.isCertified && !result.isUsable)
    result.notes.push_back(
        "Certified, but some triangles are too small for practical use "
        "(smallest to mean area scale below machine precision).");
  if (!result.conflict.empty())
    result.notes.push_back(
        "No map turns all frames as asked: " + std::to_string(result.conflict.size()) +
        " constrained triangles work against each other (see conflict).");
  if (!result.isCertified && hasGivenFrames)
    result.notes.push_back(
        "The frames were those of the given field, as asked. Automatic frames have the same cones, "
        "turning and handles but turn evenly, and may be certified where these are not.");
}

using Clock = std::chrono::steady_clock;
double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

/// Solve, judge, repair, until certified or out of ideas [BCW17 §7].
static Result<Parametrization> parametrizePrepared(const TriMesh& mesh, FieldContext context,
                                                   const HolonomySpec& spec,
                                                   const ParametrizeOptions& options,
                                                   bool isAutomatic, Parametrization result) {
  Result<SeamlessSetup> prepared =
      prepareSeamless(mesh, std::move(context), spec, options, result.times);
  if (!prepared) return std::move(prepared).error();
  const SeamlessSetup& setup = *prepared;
  result.spec = setup.field.spec;
  result.notes = setup.warnings;

  const auto start = Clock::now();
  const bool isDisk = setup.context.topology.genus == 0 && setup.context.topology.loops.size() == 1;
  const bool isFlatTorus = setup.cones.empty() && setup.context.topology.loops.empty();
  RepairPlan plan(mesh, setup, options.useQuality, (isAutomatic && !isFlatTorus) || isDisk);
  const Judge judge(mesh);
  std::optional<Attempt> best;
  bool bestIsHarmonic = false;
  for (int round = 1; round <= options.maxRounds; ++round) {
    const std::optional<RepairStep> step = plan.next();
    if (!step) break;
    if (!report(options.progress, {"solve", 0.0, -1, -1.0, round, options.maxRounds}))
      return cancelled("solve");
    const auto roundStart = Clock::now();
    bool isCancelled = false;
    Attempt attempt = solveAndJudge(mesh, setup, judge, *step, round, options, isCancelled);
    if (isCancelled) return cancelled("solve");
    result.rounds.push_back(describe(attempt, *step, secondsSince(roundStart)));
    plan.learn(attempt.program, attempt.certificate);
    if (!best || distanceToCertified(attempt) < distanceToCertified(*best)) {
      best = std::move(attempt);
      bestIsHarmonic = step->quality == 0.0;
    }
    if (best->certificate.isCertified) break;
  }
  result.times.push_back({"solve", secondsSince(start)});
  if (!best) return Failure{ErrorCode::kUsage, "solve", "At least one round is needed.", {}};

  result.map = std::move(best->map);
  result.copyOf = setup.cut.parent.raw();
  result.certificate = std::move(best->certificate);
  result.isCertified = result.certificate.isCertified;
  result.isUsable = result.certificate.isUsable;
  result.isHarmonic = bestIsHarmonic;
  if (!result.isCertified) result.conflict = best->program.conflict;
  explain(setup, options.frames.has_value(), result);
  return result;
}

Result<Parametrization> parametrize(const TriMesh& mesh, const HolonomySpec& spec,
                                    const ParametrizeOptions& options) {
  Parametrization result;
  StageClock clock(options.progress, result.times);
  if (!clock.begin("prepare")) return cancelled("solve");
  Result<FieldContext> context = prepareFields(mesh);
  if (!context) return std::move(context).error();
  clock.end();
  return parametrizePrepared(mesh, std::move(*context), spec, options, false, std::move(result));
}

Result<Parametrization> parametrizeAutomatically(const TriMesh& mesh, const SuggestOptions& cones,
                                                 const ParametrizeOptions& options) {
  if (options.frames)
    return Failure{ErrorCode::kUsage,
                   "field",
                   "Given frames come with cones of their own; here the cones are chosen.",
                   {}};
  Parametrization result;
  StageClock clock(options.progress, result.times);
  if (!clock.begin("prepare")) return cancelled("solve");
  FieldContext context = prepareSurface(mesh);
  if (!clock.begin("cones")) return cancelled("solve");
  Result<HolonomySpec> spec = chooseCones(mesh, context, cones);
  if (!spec) return std::move(spec).error();
  if (!clock.begin("connection")) return cancelled("solve");
  if (Status done = prepareConnection(mesh, context); !done) return std::move(done).error();
  if (isNearlyFlatTorus(context)) spec->cones.clear();
  clock.end();
  return parametrizePrepared(mesh, std::move(context), *spec, options, true, std::move(result));
}

}  // namespace hgp
