#include "hgp/parametrize/solution.h"

#include <string_view>

#include "hgp/improve/improve.h"
#include "hgp/parametrize/stage_clock.h"

namespace hgp {
namespace {

/// Isometric is promised never to raise the symmetric Dirichlet energy that the judge measures: on the
/// surface itself, where the descent sees slivers made harmless.
bool isBetter(const Improvement& run, const ImproveOptions& asked, const Certificate& before,
              const Certificate& after) {
  if (!after.isCertified || after.isUsable < before.isUsable) return false;
  if (!(run.excessAfter < run.excessBefore)) return false;
  return asked.balance != 0.0 ||
         after.distortion.symmetricDirichlet <= before.distortion.symmetricDirichlet;
}

}  // namespace

Status improveSolution(const TriMesh& mesh, const ParametrizeOptions& options, Judged& judged,
                       Parametrization& result) {
  StageClock clock(options.progress, result.times);
  if (!clock.begin("improve")) return cancelled("improve");
  const SeamlessSetup& setup = *judged.solution.setup;
  const ReducedMap map{mesh, setup.context->geometry, setup.cut, setup.unknowns};
  const Improvement run =
      improve(map, setup.context->tree, judged.solution.x, *options.improve, {}, options.progress);
  if (std::string_view(run.outcome) == "cancelled") return cancelled("improve");

  ImprovementFacts facts;
  facts.asked = *options.improve;
  facts.steps = run.steps;
  facts.outcome = run.outcome;
  facts.before = judged.certificate.distortion;
  Judged improved{judged.solution, {}, {}};
  improved.solution.x = run.x;
  improved.map = layOut(mesh, improved.solution);
  improved.certificate = certify(mesh, result.spec, improved.map);
  facts.isKept = isBetter(run, facts.asked, judged.certificate, improved.certificate);
  if (facts.isKept) {
    judged = std::move(improved);
  } else if (!run.steps.empty()) {
    result.notes.push_back(
        "The map is as before the improvement, which the judge did not accept: " +
        (improved.certificate.reasons.empty()
             ? std::string("it is no better on the surface itself.")
             : improved.certificate.reasons[0].message));
  }
  facts.after = judged.certificate.distortion;
  result.improvement = std::move(facts);
  return Done{};
}

bool finish(const TriMesh&, const ParametrizeOptions&, Solution&) {
  return false;  // nothing yet: grid/ and snapping are called here
}

UvMap layOut(const TriMesh& mesh, const Solution& solution) {
  const SeamlessSetup& setup = *solution.setup;
  if (solution.x.size() == 0) return layOut(mesh, setup, {});
  const Eigen::VectorXcd z = setup.unknowns.copies * solution.x;
  return layOut(mesh, setup, std::vector<Complex>(z.data(), z.data() + z.size()));
}

}  // namespace hgp
