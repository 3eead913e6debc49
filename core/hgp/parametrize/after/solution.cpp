#include "hgp/parametrize/after/solution.h"

#include <algorithm>
#include <cmath>

#include "hgp/grid/align.h"
#include "hgp/grid/grid_measures.h"
#include "hgp/grid/snap.h"
#include "hgp/improve/improve.h"
#include "hgp/mesh/map_area.h"
#include "hgp/parametrize/after/real_pairs.h"
#include "hgp/parametrize/stage_clock.h"
#include "hgp/quads/cut_strips.h"
#include "hgp/quads/near_seams.h"

namespace hgp {
namespace {

/// Multiply-adds per triangle of a run apart from its programs: fields, cut, verifying (measured).
constexpr double kBesidePrograms = 1.2e4;
/// Maximum work of alignment and the descent after it, relative to that of the run without a grid.
constexpr double kAlignShare = 1.5;
/// That descent ends at this multiple of the requested relative decrease, because it starts near its end.
constexpr double kHeldDecrease = 3.0;
/// Fraction of the stage "align" that is done when that descent starts.
constexpr double kAlignedFraction = 0.9;

/// @param isHeld  by unknown or, along features, by real unknown; empty: none
Improvement descend(const TriMesh& mesh, const Solution& solution, const ImproveOptions& options,
                    const std::vector<char>& isHeld, const Progress& progress) {
  const SeamlessSetup& setup = *solution.setup;
  const auto over = [&](const ReducedUnknowns& unknowns, const Eigen::VectorXcd& x,
                        const std::vector<char>& held) {
    return improve({mesh, setup.context->ownGeometry(), setup.cut, unknowns}, setup.context->tree,
                   x, options, held, progress);
  };
  if (!solution.real) return over(setup.unknowns, solution.x, isHeld);
  const RealPairs pairs(mesh, setup.cut, setup.unknowns, *solution.real, isHeld);
  const std::vector<int>& variable = solution.real->variable;
  Improvement run =
      over(pairs.unknowns(), pairs.pairsOf(partsOf(solution.x, variable)), pairs.isHeld());
  const Eigen::VectorXd values = partsOf(run.x, pairs.parts());
  run.x = solution.x;
  setParts(values, variable, run.x);
  return run;
}

/// The requested distortion as the verifier measures it: on the surface itself, while the descent works with thickened
/// slivers; and as a mean, while single triangles can dominate an energy.
double askedNumber(const ImproveOptions& asked, const DistortionFacts& facts) {
  if (asked.balance == -1.0) return facts.meanMu;
  return asked.balance == 1.0 ? facts.rmsLogArea : facts.symmetricDirichlet;
}

/// A distortion that is requested by name must not rise as the verifier measures it; the docs promise that.
bool isBetter(const Improvement& run, const ImproveOptions& asked, const Certificate& before,
              const Certificate& after) {
  if (!after.isCertified || after.isUsable < before.isUsable) return false;
  if (!(run.excessAfter < run.excessBefore)) return false;
  const bool isNamed = asked.balance == 0.0 || std::fabs(asked.balance) == 1.0;
  return !isNamed || askedNumber(asked, after.distortion) <= askedNumber(asked, before.distortion);
}

/// Replaces `mapped` by `improved`, if there is one, and returns the facts of the descent.
DescentFacts takeOver(const Improvement& run, std::optional<MappedSolution> improved,
                      MappedSolution& mapped) {
  DescentFacts facts;
  facts.steps = run.steps;
  facts.outcome = run.outcome;
  facts.multiplyAdds = run.multiplyAdds;
  facts.before = mapped.certificate.distortion;
  facts.isKept = improved.has_value();
  if (improved) mapped = std::move(*improved);
  facts.after = mapped.certificate.distortion;
  return facts;
}

/// The map of the improved unknowns with its certificate; nothing, with a note, if it is not certified.
std::optional<MappedSolution> accepted(const TriMesh& mesh, const Improvement& run,
                                       const ImproveOptions& asked, const MappedSolution& mapped,
                                       Parametrization& result) {
  if (run.steps.empty()) return {};
  MappedSolution improved{mapped.solution, {}, {}};
  improved.solution.x = run.x;
  improved.map = layOut(mesh, improved.solution);
  improved.certificate = certify(mesh, result.spec, improved.map);
  if (isBetter(run, asked, mapped.certificate, improved.certificate)) return improved;
  Note note("map-not-improved");
  if (const auto& reasons = improved.certificate.reasons; !reasons.empty())
    note = Note("map-not-improved",
                {{"rule", ruleName(reasons[0].rule)},
                 {"places", reasons[0].count},
                 {"worst", reasons[0].worst}},
                reasons[0].where);
  result.notes.push_back(std::move(note));
  return {};
}

/// Per unknown, 1 if alignment determined it: translations and, in quad mode, cones.
std::vector<char> heldByGrid(const SeamlessSetup& setup, GridMode mode) {
  std::vector<char> isHeld(static_cast<std::size_t>(setup.unknowns.count), 0);
  const auto hold = [&](int unknown) {
    if (unknown >= 0) isHeld[static_cast<std::size_t>(unknown)] = 1;
  };
  for (const int unknown : setup.unknowns.chainUnknown) hold(unknown);
  if (mode == GridMode::kQuad)
    for (VertexId cone : setup.cones) hold(setup.unknowns.vertexUnknown[cone]);
  return isHeld;
}

Eigen::VectorXcd unknownsOf(const TriMesh& mesh, const SeamlessSetup& setup, const UvMap& map) {
  std::vector<Complex> z;
  z.reserve(map.uv.size());
  for (const Vec2& p : map.uv) z.emplace_back(p[0], p[1]);
  return readUnknowns(mesh, setup.cut, setup.seams, setup.unknowns, z);
}

/// Whether what is held has the same bits in both.
bool isSameWhereHeld(const std::vector<char>& isHeld, const Solution& a, const Solution& b) {
  const RealUnknowns* real = a.real;
  const auto *p = reinterpret_cast<const double*>(a.x.data()),
             *q = reinterpret_cast<const double*>(b.x.data());
  for (std::size_t i = 0; i < isHeld.size(); ++i) {
    if (!isHeld[i]) continue;
    const std::size_t part = real ? at(real->variable[i]) : 2 * i;
    if (p[part] != q[part] || (!real && p[part + 1] != q[part + 1])) return false;
  }
  return true;
}

/// The improved unknowns in cells, snapped and verified; nothing unless the map is better and still aligned, and the
/// held values are the same bits.
std::optional<MappedSolution> acceptedOnGrid(const TriMesh& mesh, const Improvement& run,
                                             const ImproveOptions& asked,
                                             const std::vector<char>& isHeld,
                                             const MappedSolution& mapped,
                                             const CompleteSpec& spec) {
  if (run.steps.empty()) return {};
  const SeamlessSetup& setup = *mapped.solution.setup;
  MappedSolution improved{mapped.solution, {}, {}};
  improved.solution.x = run.x;
  UvMap moved = mapped.map;
  moved.uv.clear();
  for (const Complex& p : placesOf(improved.solution)) moved.uv.push_back({p.real(), p.imag()});
  std::optional<UvMap> snapped =
      snapAligned(mesh, std::move(moved), setup.seams.q, setup.cones, spec.features);
  if (!snapped) return {};
  improved.map = std::move(*snapped);
  improved.solution.x = unknownsOf(mesh, setup, improved.map);
  if (!isSameWhereHeld(isHeld, improved.solution, mapped.solution)) return {};
  improved.certificate = certify(mesh, spec, improved.map);
  if (improved.certificate.exactSeams.integer != mapped.certificate.exactSeams.integer) return {};
  if (!isBetter(run, asked, mapped.certificate, improved.certificate)) return {};
  return improved;
}

/// Maps whose quads have edges that files cannot tell apart are second choices, with what separating these edges adds.
Verdict verdictOnQuads(const TriMesh& mesh, const UvMap& map, const SeamlessSetup& setup) {
  const std::optional<UvMap> snapped = snapAligned(mesh, map, setup.seams.q, setup.cones);
  if (!snapped || !hasMultipleEdges(mesh, *snapped, setup.cut.isSeam)) return Acceptance::kAccepted;
  const Result<CutQuads> cut = cutStrips(mesh, *snapped, setup.seams.q);
  // Otherwise all cells are cut into four, at least.
  return {Acceptance::kSecondChoice, cut ? cut->added : 3.0 * mapArea(*snapped)};
}

}  // namespace

Status improveSolution(const TriMesh& mesh, const ParametrizeOptions& options,
                       MappedSolution& mapped, Parametrization& result) {
  StageClock clock(options.progress, result.times);
  if (!clock.begin(Stage::kImprove)) return clock.cancelled();
  const Improvement run = descend(mesh, mapped.solution, *options.improve, {}, options.progress);
  if (run.outcome == DescentOutcome::kCancelled) return cancelled(Stage::kImprove);
  std::optional<MappedSolution> improved = accepted(mesh, run, *options.improve, mapped, result);
  result.improvement = {takeOver(run, std::move(improved), mapped), *options.improve, {}};
  return Done{};
}

Status improveOnGrid(const TriMesh& mesh, const ParametrizeOptions& options,
                     const std::vector<char>& isHeld, double multiplyAdds, MappedSolution& mapped,
                     Parametrization& result) {
  if (std::find(isHeld.begin(), isHeld.end(), 1) == isHeld.end()) return Done{};
  const Progress silent;
  StageClock clock(silent,
                   result.times);  // not reported: for the caller it is part of stage "align"
  clock.begin(Stage::kImprove);
  ImproveOptions asked = *options.improve;
  asked.maxMultiplyAdds = multiplyAdds;
  asked.relativeDecrease *= kHeldDecrease;
  const ImprovementFacts& first = *result.improvement;
  // Alignment added less distortion than the decrease at which a descent ends, so a descent would gain nothing.
  if (first.isKept &&
      askedNumber(asked, mapped.certificate.distortion) <=
          (1.0 + options.improve->relativeDecrease) * askedNumber(asked, first.after)) {
    Improvement none;
    none.outcome = DescentOutcome::kNothingToGain;
    result.improvement->onGrid = takeOver(none, {}, mapped);
    return Done{};
  }
  const Progress progress = [&](const ProgressReport& r) {
    const double fraction = kAlignedFraction + (1.0 - kAlignedFraction) * r.fraction;
    return report(options.progress, {Stage::kAlign, fraction, r.iteration, r.residual});
  };
  const Improvement run = descend(mesh, mapped.solution, asked, isHeld, progress);
  if (run.outcome == DescentOutcome::kCancelled) return cancelled(Stage::kAlign);
  std::optional<MappedSolution> improved =
      acceptedOnGrid(mesh, run, asked, isHeld, mapped, result.spec);
  result.improvement->onGrid = takeOver(run, std::move(improved), mapped);
  describeGrid(mesh, mapped.map, mapped.solution.setup->cones.size(), *result.grid);
  return Done{};
}

Status evenOut(const TriMesh& mesh, const ParametrizeOptions& options, MappedSolution& mapped,
               Parametrization& result) {
  if (!mapped.certificate.isMeasured) return Done{};
  StageClock clock(options.progress, result.times);
  if (!clock.begin(Stage::kImprove)) return clock.cancelled();
  const Improvement run = descend(mesh, mapped.solution, {}, {}, options.progress);
  if (run.outcome == DescentOutcome::kCancelled) return cancelled(Stage::kImprove);
  MappedSolution even{mapped.solution, {}, {}};
  even.solution.x = run.x;
  even.map = layOut(mesh, even.solution);
  even.certificate = certify(mesh, result.spec, even.map);
  if (!even.certificate.isCertified) return Done{};
  mapped = std::move(even);
  result.notes.emplace_back("map-areas-lowered");
  return Done{};
}

double alignmentMultiplyAdds(const TriMesh& mesh, const Parametrization& result) {
  double sum = kBesidePrograms * mesh.faceCount();
  for (const Round& round : result.rounds) sum += round.multiplyAdds;
  if (result.improvement) sum += result.improvement->multiplyAdds;
  return kAlignShare * sum;
}

Status alignSolution(const TriMesh& mesh, const ParametrizeOptions& options, MappedSolution& mapped,
                     Parametrization& result) {
  StageClock clock(options.progress, result.times);
  if (!clock.begin(Stage::kAlign)) return clock.cancelled();
  const SeamlessSetup& setup = *mapped.solution.setup;
  Certificate certificate;
  const auto accepts = [&](const UvMap& map) -> Verdict {
    certificate = certify(mesh, result.spec, map);
    if (!certificate.isCertified) return Acceptance::kRefused;
    if (options.grid.mode == GridMode::kTile) return Acceptance::kAccepted;
    return verdictOnQuads(mesh, map, setup);
  };
  AlignedMap aligned =
      alignToGrid(mesh, mapped.map, setup.seams.q, setup.cones, options.grid, &setup.context->tree,
                  options.progress, alignmentMultiplyAdds(mesh, result), accepts);
  if (aligned.isCancelled) return cancelled(Stage::kAlign);
  result.grid = std::move(aligned.report);
  if (!aligned.map) return Done{};
  mapped.solution.x = unknownsOf(mesh, setup, *aligned.map);
  mapped.map = std::move(*aligned.map);
  mapped.certificate =
      aligned.isSecondChoice ? certify(mesh, result.spec, mapped.map) : std::move(certificate);
  if (!options.improve) return Done{};
  clock.end();
  return improveOnGrid(mesh, options, heldByGrid(setup, options.grid.mode),
                       aligned.multiplyAddsLeft, mapped, result);
}

UvMap layOut(const TriMesh& mesh, const Solution& solution) {
  const SeamlessSetup& setup = *solution.setup;
  return layOut(mesh, setup, solution.x.size() == 0 ? std::vector<Complex>() : placesOf(solution));
}

std::vector<Complex> placesOf(const Solution& solution) {
  if (solution.real) return placesOf(*solution.real, partsOf(solution.x, solution.real->variable));
  const Eigen::VectorXcd z = solution.setup->unknowns.copies * solution.x;
  return {z.data(), z.data() + z.size()};
}

}  // namespace hgp
