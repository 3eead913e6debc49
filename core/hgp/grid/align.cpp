#include "hgp/grid/align.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/check.h"
#include "hgp/base/portable_math.h"
#include "hgp/base/stable_order.h"
#include "hgp/grid/align_work.h"
#include "hgp/grid/grid_measures.h"
#include "hgp/grid/grid_system.h"
#include "hgp/grid/repair_change.h"
#include "hgp/grid/rounded_map.h"
#include "hgp/mesh/map_area.h"

namespace hgp {
namespace {

/// Densities tried by the linear step, as factors of the map's scale. The first ones change the number of cells by at
/// most a tenth; the others are tried only if none of these gives a map.
constexpr double kFactors[] = {1.0, 1.03, 0.97, 1.045, 0.955, 1.12, 1.19, 1.27, 1.35};
constexpr double kNear = 1.05;
/// Quads are as many as asked for within this fraction.
constexpr double kAsAsked = 0.1;
/// Number of rings of a patch around flipped triangles, and its minimum width in cells, which matters on fine meshes.
constexpr int kRings = 6;
constexpr double kPatchCells = 1.2;
/// Number of the best densities that are tried again with larger patches.
constexpr std::size_t kRepairedAgain = 2;
constexpr double kPatchShare = 0.35;
/// Maximum number of triangles for a program on the whole mesh, and of rounds in which its constraint set grows.
constexpr int kLargestWhole = 150'000;
constexpr int kWholeRounds = 4;
/// Cones closer than this many cells are kept apart.
constexpr double kReach = 3.0;
constexpr int kDenser = 8;  ///< doublings of the number of cells to find one that works
/// Reported progress as fractions of the stage: before the first density, and the part of all densities together.
constexpr double kBegun = 0.1, kStepping = 0.5;
constexpr std::size_t kNamed = 3;  ///< pairs of cones that the report names

struct Candidate {
  double factor = 1.0;
  double scale = 1.0;
  Eigen::VectorXcd x;
  std::vector<FaceId> turned;
  bool isApart = true;  ///< neighbouring cones kept their direction
};

class Aligner {
 public:
  Aligner(const TriMesh& mesh, const UvMap& map, const GridSystem& system,
          const std::vector<VertexId>& cones, const GridOptions& options, const Progress& progress,
          double work, const std::function<Verdict(const UvMap&)>& accepts)
      : mesh_(mesh),
        system_(system),
        cones_(cones),
        progress_(progress),
        context_{mesh, system.seams(), system.change(), system.uv(), system.weights()},
        mapArea_(mapArea(map)),
        surfaceArea_(surfaceArea(mesh)),
        accepts_(accepts),
        isForQuads_(options.mode == GridMode::kQuad),
        repairWork_(kRepairShare * work),
        work_(work - system.factorWork()) {
    const double cells =
        options.cells > 0.0 ? options.cells : surfaceArea_ / (options.spacing * options.spacing);
    scale_ = std::sqrt(cells / mapArea_);
  }

  AlignedMap run() {
    out_.report.integers = system_.integerCount();
    out_.report.cells = mapArea_ * scale_ * scale_;
    out_.report.spacing = std::sqrt(surfaceArea_ / mapArea_) / scale_;
    out_.report.cellsPerCone =
        out_.report.cells / std::max<double>(1.0, static_cast<double>(cones_.size()));
    reserved_ = kExplaining * work_;
    tryAll();
    if (!isDone() && secondChoice_) takeSecondChoice();
    if (!isDone()) explain();
    out_.multiplyAddsLeft = std::max(0.0, work_);
    return std::move(out_);
  }

 private:
  /// Tries the densities, the requested one first, each with repairs where triangles are flipped; then the best again
  /// with larger patches.
  void tryAll() {
    std::vector<Candidate> candidates = linearSteps();
    if (isDone() || secondChoice_) return;
    // A map without flipped triangles that the verifier refused cannot be repaired here.
    std::erase_if(candidates, [](const Candidate& candidate) { return candidate.turned.empty(); });
    sortStably(candidates,
               [](const auto& a, const auto& b) { return a.turned.size() < b.turned.size(); });
    candidates.resize(std::min(candidates.size(), kRepairedAgain));
    for (Candidate& candidate : candidates)
      if (repairOnPatches(candidate, 4 * rings())) return;
    for (Candidate& candidate : candidates)
      if (repairAsWhole(candidate)) return;
  }

  bool isDone() const { return out_.isCancelled || out_.map.has_value(); }
  /// Reports progress, which never decreases; false once the caller has cancelled.
  bool goOn(double fraction) {
    fraction_ = std::max(fraction_, fraction);
    if (!report(progress_, {Stage::kAlign, fraction_})) out_.isCancelled = true;
    return !out_.isCancelled;
  }
  /// Whether this much work may still be spent; if not, the report says that steps were skipped.
  bool affords(double work) {
    if (work <= work_ - reserved_) return true;
    isCutShort_ = true;
    return false;
  }

  std::vector<Candidate> linearSteps() {
    std::vector<Candidate> candidates;
    if (!goOn(kBegun)) return candidates;
    const IntegerChoice choice = system_.choice(2.0 * kReach / scale_);
    Candidate next = firstStep(choice);
    const double base = next.factor;
    for (double factor : kFactors) {
      if (factor > kNear && secondChoice_ && secondOff_ <= kAsAsked) break;
      const double tried = static_cast<double>(candidates.size()) / std::size(kFactors);
      if (!goOn(kBegun + kStepping * tried) || (!candidates.empty() && !affords(stepWork()))) break;
      if (!candidates.empty()) next = linearStep(choice, base * factor);
      if (tryStep(std::move(next), candidates)) break;
    }
    // The density itself, which explain() may have recommended: a map of more or fewer cells is better than none.
    if (base != 1.0 && !isDone() && !secondChoice_ && affords(stepWork()))
      tryStep(linearStep(choice, 1.0), candidates);
    return candidates;
  }
  bool tryStep(Candidate next, std::vector<Candidate>& candidates) {
    candidates.push_back(std::move(next));
    if (accept(candidates.back(), "linear step")) return true;
    // The choice of many integers may have used up the work; repairs have their own reserve.
    if (candidates.size() == 1) work_ = std::max(work_, repairWork_ + reserved_);
    return repairOnPatches(candidates.back(), rings());
  }
  double stepWork() const {
    return linearStepWork(mesh_.faceCount(), system_.solveWork(), system_.integerCount());
  }

  /// The linear step at the requested density or, for quads, at one that gives the requested number of cells.
  Candidate firstStep(const IntegerChoice& choice) {
    if (!isForQuads_) return linearStep(choice, 1.0);
    const auto affordsStep = [this] {
      // Without exact orientations.
      const double step = kCountShare * stepWork();
      if (!affords(step)) return false;
      work_ -= step;
      return true;
    };
    return candidate(
        choice, roundedToCells(system_, context_, choice, scale_, out_.report.cells, affordsStep));
  }
  Candidate linearStep(const IntegerChoice& choice, double factor) {
    return candidate(choice, roundedMap(system_, context_, choice, scale_, factor));
  }
  Candidate candidate(const IntegerChoice& choice, RoundedMap map) {
    work_ -= stepWork();
    Candidate out{map.factor, map.scale, std::move(map.x), {}};
    out.isApart = choice.wrongPairs(system_.relaxed(out.scale), map.y) == 0;
    out.turned = turnedFaces(context_, out.x);
    return out;
  }

  bool accept(const Candidate& candidate, const std::string& method) {
    out_.report.attempts.push_back(
        {method, candidate.factor * candidate.factor, static_cast<int>(candidate.turned.size())});
    if (!candidate.turned.empty()) return false;
    std::optional<UvMap> map = system_.alignedMap(candidate.x, candidate.scale);
    if (!map) return false;
    Verdict verdict = accepts_ ? accepts_(*map) : Acceptance::kAccepted;
    const double quads = mapArea(*map) + verdict.added;
    const double off = isForQuads_ ? std::fabs(quads / out_.report.cells - 1.0) : 0.0;
    if (verdict.acceptance == Acceptance::kAccepted && off > kAsAsked)
      verdict.acceptance = Acceptance::kSecondChoice;
    switch (verdict.acceptance) {
      case Acceptance::kAccepted:
        take(std::move(*map), verdict.added);
        return true;
      case Acceptance::kSecondChoice:
        out_.report.attempts.back().method += ", second choice";
        if (secondChoice_ && (secondOff_ <= kAsAsked || off >= secondOff_)) break;
        secondChoice_ = std::move(map);
        secondOff_ = off;
        secondAdded_ = verdict.added;
        secondAttempt_ = out_.report.attempts.size() - 1;
        break;
      case Acceptance::kRefused:
        out_.report.attempts.back().method += ", not certified";
        break;
    }
    work_ -= kVerifyWork * mesh_.faceCount();
    return false;
  }
  void take(UvMap map, double added) {
    out_.map = std::move(map);
    out_.report.isAligned = true;
    out_.report.added = added;
    describeGrid(mesh_, *out_.map, cones_.size(), out_.report);
  }
  void takeSecondChoice() {
    // The last attempt is the one that produced the map.
    std::vector<GridAttempt>& attempts = out_.report.attempts;
    const auto chosen = attempts.begin() + static_cast<std::ptrdiff_t>(secondAttempt_);
    std::rotate(chosen, chosen + 1, attempts.end());
    take(std::move(*secondChoice_), secondAdded_);
    out_.isSecondChoice = true;
  }

  bool repair(const std::vector<FaceId>& patch, const std::vector<FaceId>& bound,
              Candidate& candidate) {
    double spent = 0.0;
    const bool isRepaired = repairChange(context_, patch, bound, system_.isHeld(), candidate.x,
                                         spent, [&](const ProgressReport&) { return goOn(0.0); });
    work_ -= spent + kProgramWork * static_cast<double>(patch.size());
    return isRepaired;
  }

  /// Repairs around flipped triangles.
  int rings() const {
    const double edgesPerCell = std::sqrt(0.5 * mesh_.faceCount() / out_.report.cells);
    return std::max(kRings, static_cast<int>(std::ceil(kPatchCells * edgesPerCell)));
  }
  /// Repairs every patch separately while there is work left; keeps the candidate if that leaves no fewer flipped
  /// triangles.
  bool repairPatches(Candidate& candidate, int rings) {
    Candidate repaired = candidate;
    for (const std::vector<FaceId>& patch : patchesAround(mesh_, candidate.turned, rings)) {
      if (!goOn(0.0)) return false;
      if (static_cast<double>(patch.size()) > kPatchShare * mesh_.faceCount()) continue;
      if (!affords(programWork(patch.size(), patch.size()))) break;
      repair(patch, patch, repaired);
    }
    repaired.turned = turnedFaces(context_, repaired.x);
    if (repaired.turned.size() >= candidate.turned.size()) return false;
    candidate = std::move(repaired);
    return true;
  }
  /// True when there is nothing more to do: aligned, or cancelled.
  bool repairOnPatches(Candidate& candidate, int rings) {
    if (!repairPatches(candidate, rings)) return isDone();
    return accept(candidate, formatText("patches of %d rings", rings));
  }

  /// Solves for all unknowns but the integers, with conditions around cones and flipped triangles.
  bool repairAsWhole(Candidate& candidate) {
    // Cones that were rounded to one point cause folds that no program can remove.
    if (mesh_.faceCount() > kLargestWhole || !candidate.isApart) return false;
    std::vector<FaceId> all;
    for (FaceId f : mesh_.faces()) all.push_back(f);
    std::vector<FaceId> bound = growFaces(mesh_, candidate.turned, 2);
    for (int round = 0; round < kWholeRounds; ++round) {
      if (!goOn(0.7)) return true;
      if (!affords(programWork(all.size(), bound.size()))) return false;
      Candidate repaired = candidate;
      if (!repair(all, bound, repaired)) {
        if (!goOn(0.7)) return true;
        out_.report.attempts.push_back({"whole mesh, not solved",
                                        candidate.factor * candidate.factor,
                                        static_cast<int>(candidate.turned.size())});
        return false;
      }
      repaired.turned = turnedFaces(context_, repaired.x);
      if (accept(repaired, "whole mesh")) return true;
      if (repaired.turned.empty()) return false;
      const std::vector<FaceId> more = growFaces(mesh_, repaired.turned, 2);
      bound.insert(bound.end(), more.begin(), more.end());
      std::sort(bound.begin(), bound.end());
      bound.erase(std::unique(bound.begin(), bound.end()), bound.end());
    }
    return false;
  }

  /// The closest cones, and the first denser grid on which the linear step or small patches succeed.
  void explain() {
    GridReport& report = out_.report;
    for (const ConePair& pair : system_.neighbours(1.0 / scale_).pairs)
      report.closest.push_back({pair.a, pair.b, scale_ * portable::abs(pair.distance)});
    sortStably(report.closest,
               [](const ConeDistance& a, const ConeDistance& b) { return a.cells < b.cells; });
    report.closest.resize(std::min(report.closest.size(), kNamed));
    report.reason = Note("grid-no-integers", {{"cells", report.cells},
                                              {"perCone", report.cellsPerCone},
                                              {"cutShort", isCutShort_ ? 1 : 0}});
    // Programs may have cost more than expected. This search still has its reserve, and at least the cost of its linear
    // steps if there are few integers.
    const double plainStep = linearStepWork(mesh_.faceCount(), system_.solveWork(), 0);
    work_ = std::max({work_, reserved_, 1.5 * kDenser * plainStep});
    reserved_ = 0.0;
    double factor = 1.0;
    for (int n = 0; n < kDenser && affords(stepWork()); ++n) {
      factor *= std::sqrt(2.0);
      if (!goOn(0.9)) return;
      Candidate denser = linearStep(system_.choice(2.0 * kReach / (scale_ * factor)), factor);
      // Patches may not use the work of the remaining linear steps.
      reserved_ = (kDenser - n) * plainStep;
      repairPatches(denser, kRings);
      reserved_ = 0.0;
      if (!denser.turned.empty()) continue;
      report.workingCells = mapArea_ * denser.scale * denser.scale;
      return;
    }
  }

  const TriMesh& mesh_;
  const GridSystem& system_;
  const std::vector<VertexId>& cones_;
  const Progress& progress_;
  const ChangeContext context_;
  const double mapArea_, surfaceArea_;
  const std::function<Verdict(const UvMap&)>& accepts_;
  const bool isForQuads_;
  const double repairWork_;  ///< multiply-adds reserved for repairs
  double scale_ = 1.0;
  double work_, reserved_ = 0.0;  ///< multiply-adds left, and how many of them are for explain()
  bool isCutShort_ = false;
  double fraction_ = 0.0;  ///< of the stage, as last reported
  std::optional<UvMap> secondChoice_;
  double secondOff_ = 0.0, secondAdded_ = 0.0;
  std::size_t secondAttempt_ = 0;
  AlignedMap out_;
};

}  // namespace

AlignedMap alignToGrid(const TriMesh& mesh, const UvMap& map, int q,
                       const std::vector<VertexId>& cones, const GridOptions& options,
                       const linalg::SeparatorTree* tree, const Progress& progress, double work,
                       const std::function<Verdict(const UvMap&)>& accepts) {
  AlignedMap failed;
  if (q != 2 && q != 4) {
    failed.report.reason = Note("grid-order", {{"q", q}});
    return failed;
  }
  const std::unique_ptr<GridSystem> system =
      GridSystem::make(mesh, map, q, cones, options.mode, tree);
  if (!system) {
    failed.report.reason = Note("grid-seams");
    return failed;
  }
  return Aligner(mesh, map, *system, cones, options, progress, work, accepts).run();
}

}  // namespace hgp
