#include "hgp/grid/align.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/check.h"
#include "hgp/base/portable_math.h"
#include "hgp/grid/grid_system.h"
#include "hgp/grid/repair_change.h"
#include "hgp/mesh/vectors.h"

namespace hgp {
namespace {

/// Densities tried by the linear step, as factors of the edge length.
constexpr double kFactors[] = {1.0, 1.06, 0.94, 1.12, 1.19, 1.27, 1.35};
/// Of those that turned triangles over, at most so many are repaired, best first.
constexpr std::size_t kRepaired = 4;
constexpr std::size_t kRepairedAsWhole = 2;
constexpr int kPatchRings[] = {6, 24};
constexpr double kPatchShare = 0.35;
/// Programs on the whole mesh, at most so many triangles large, and their rounds of growth.
constexpr int kLargestWhole = 150'000;
constexpr int kWholeRounds = 4;
/// Cones within so many cells are kept apart.
constexpr double kReach = 3.0;
constexpr int kDenser = 8;  ///< doublings of the density that are tried to name one that works
/// Of all work, what is kept for naming such a density.
constexpr double kExplaining = 0.15;
/// … and at least so much for repairs, whatever the choice of many integers took.
constexpr double kRepairShare = 0.25;
/// Multiply-adds per triangle of verifying a map.
constexpr double kVerifyWork = 3e3;
/// Multiply-adds per triangle of a linear step beside its back-substitution: copies, exact orientation.
constexpr double kStepWork = 1200.0;
/// … and of the choice of k integers, by k³: rank-one changes of a complex matrix, bound by memory.
constexpr double kRoundingWork = 20.0;
/// Interior-point iterations that a program is expected to need.
constexpr int kExpectedIterations = 14;
constexpr std::size_t kNamed = 3;  ///< pairs of cones that the report names

double areaOf(const UvMap& map) {
  double area = 0.0;
  for (const auto& t : map.cornerUv) {
    const Vec2 &a = map.uv[at(t[0])], &b = map.uv[at(t[1])], &c = map.uv[at(t[2])];
    area += 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
  }
  return area;
}

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
          double work, const std::function<bool(const UvMap&)>& accepts)
      : mesh_(mesh),
        system_(system),
        cones_(cones),
        progress_(progress),
        context_{mesh, system.seams(), system.change(), system.uv(), system.weights()},
        mapArea_(areaOf(map)),
        surfaceArea_(surfaceArea(mesh)),
        accepts_(accepts),
        repairWork_(kRepairShare * work),
        work_(work - system.factorWork()) {
    const double cells =
        options.cells > 0.0 ? options.cells : surfaceArea_ / (options.spacing * options.spacing);
    scale_ = std::sqrt(cells / mapArea_);
  }

  AlignedMap run() {
    out_.report.integers = system_.integerCount();
    describe(scale_);
    reserved_ = kExplaining * work_;
    tryAll();
    if (!isDone()) explain();
    out_.workLeft = std::max(0.0, work_);
    return std::move(out_);
  }

 private:
  void tryAll() {
    std::vector<Candidate> candidates = linearSteps();
    if (isDone()) return;
    work_ = std::max(work_, repairWork_ + reserved_);
    // Without a triangle that turned over there is nothing to repair: the verifier has refused such a map.
    std::erase_if(candidates, [](const Candidate& candidate) { return candidate.turned.empty(); });
    std::stable_sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
      return a.turned.size() < b.turned.size();
    });
    candidates.resize(std::min(candidates.size(), kRepaired));
    for (Candidate& candidate : candidates)
      if (repairOnPatches(candidate)) return;
    candidates.resize(std::min(candidates.size(), kRepairedAsWhole));
    for (Candidate& candidate : candidates)
      if (repairAsWhole(candidate)) return;
  }

  void describe(double scale) {
    out_.report.cells = mapArea_ * scale * scale;
    out_.report.spacing = std::sqrt(surfaceArea_ / mapArea_) / scale;
    out_.report.cellsPerCone =
        out_.report.cells / std::max<double>(1.0, static_cast<double>(cones_.size()));
  }

  bool isDone() const { return out_.isCancelled || out_.map.has_value(); }
  /// False once the caller cancelled.
  bool goOn(double fraction) {
    if (!report(progress_, {Stage::kAlign, fraction})) out_.isCancelled = true;
    return !out_.isCancelled;
  }
  /// Whether so much may still be spent; what was left out for it is said.
  bool affords(double work) {
    if (work <= work_ - reserved_) return true;
    isCutShort_ = true;
    return false;
  }

  /// By density, the one asked first; the rest only while they are worth their time.
  std::vector<Candidate> linearSteps() {
    std::vector<Candidate> candidates;
    if (!goOn(0.1)) return candidates;
    const IntegerChoice choice = system_.choice(2.0 * kReach / scale_);
    for (double factor : kFactors) {
      if (!goOn(0.1) || (!candidates.empty() && !affords(stepWork()))) break;
      candidates.push_back(linearStep(choice, factor));
      if (accept(candidates.back(), "linear step")) break;
    }
    return candidates;
  }
  double stepWork() const {
    const double k = system_.integerCount();
    return kStepWork * mesh_.faceCount() + system_.solveWork() + kRoundingWork * k * k * k;
  }
  /// Expected of a program over so many triangles with conditions on `bound` of them.
  double programWork(std::size_t triangles, std::size_t bound) const {
    // Elimination grows with the power 3/2 of a planar system; real pairs cost twice complex unknowns.
    const auto share = [&](std::size_t n) {
      return portable::pow(static_cast<double>(n) / mesh_.faceCount(), 1.5);
    };
    return system_.sparseWork() *
           (share(triangles) + 2.0 * kExpectedIterations * share(std::min(triangles, bound)));
  }

  Candidate linearStep(const IntegerChoice& choice, double factor) {
    work_ -= stepWork();
    Candidate out{factor, scale_ * factor, {}, {}};
    const std::vector<Gaussian> y = choice.near(system_.relaxed(out.scale));
    out.isApart = choice.wrongSeparations(system_.relaxed(out.scale), y) == 0;
    out.x = system_.changeTo(y, out.scale);
    out.turned = turnedFaces(context_, out.x);
    return out;
  }

  bool accept(const Candidate& candidate, const char* method) {
    out_.report.attempts.push_back(
        {method, candidate.factor * candidate.factor, static_cast<int>(candidate.turned.size())});
    if (!candidate.turned.empty()) return false;
    out_.map = system_.alignedMap(candidate.x, candidate.scale);
    if (!out_.map) return false;
    if (accepts_ && !accepts_(*out_.map)) {
      out_.report.attempts.back().method += ", not certified";
      out_.map.reset();
      work_ -= kVerifyWork * mesh_.faceCount();
      return false;
    }
    out_.report.isAligned = true;
    describe(candidate.scale);
    return true;
  }

  bool repair(const std::vector<FaceId>& patch, const std::vector<FaceId>& bound,
              Candidate& candidate) {
    double spent = 0.0;
    const bool isRepaired =
        repairChange(context_, patch, bound, system_.isHeld(), candidate.x, spent, progress_);
    work_ -= spent;
    return isRepaired;
  }

  /// True when there is nothing more to do: aligned, or cancelled.
  bool repairOnPatches(Candidate& candidate) {
    for (int rings : kPatchRings) {
      // Cones that were rounded onto each other fold on any patch.
      if (!candidate.isApart && rings > kPatchRings[0]) return false;
      if (!goOn(0.5)) return true;
      const std::vector<FaceId> patch = facesAround(mesh_, candidate.turned, rings);
      if (static_cast<double>(patch.size()) > kPatchShare * mesh_.faceCount()) return false;
      if (!affords(programWork(patch.size(), patch.size()))) return false;
      Candidate repaired = candidate;
      if (!repair(patch, patch, repaired)) continue;
      repaired.turned = turnedFaces(context_, repaired.x);
      if (accept(repaired, rings == kPatchRings[0] ? "patch of 6 rings" : "patch of 24 rings"))
        return true;
      if (!repaired.turned.empty() && repaired.turned.size() < candidate.turned.size())
        candidate = std::move(repaired);
    }
    return false;
  }

  /// Everything but the integers; conditions around cones and wherever a triangle turned over.
  bool repairAsWhole(Candidate& candidate) {
    // Cones that were rounded onto each other fold whatever the program.
    if (mesh_.faceCount() > kLargestWhole || !candidate.isApart) return false;
    std::vector<FaceId> all;
    for (FaceId f : mesh_.faces()) all.push_back(f);
    std::vector<FaceId> bound = facesAround(mesh_, candidate.turned, 2);
    for (int round = 0; round < kWholeRounds; ++round) {
      if (!goOn(0.7)) return true;
      if (!affords(programWork(all.size(), bound.size()))) return false;
      Candidate repaired = candidate;
      if (!repair(all, bound, repaired)) {
        if (!goOn(0.7)) return true;
        out_.report.attempts.push_back({"whole mesh, infeasible",
                                        candidate.factor * candidate.factor,
                                        static_cast<int>(candidate.turned.size())});
        return false;
      }
      repaired.turned = turnedFaces(context_, repaired.x);
      if (accept(repaired, "whole mesh")) return true;
      if (repaired.turned.empty()) return false;
      const std::vector<FaceId> more = facesAround(mesh_, repaired.turned, 2);
      bound.insert(bound.end(), more.begin(), more.end());
      std::sort(bound.begin(), bound.end());
      bound.erase(std::unique(bound.begin(), bound.end()), bound.end());
    }
    return false;
  }

  /// The closest cones, and the first denser grid on which the linear step succeeds.
  void explain() {
    GridReport& report = out_.report;
    for (const ConePair& pair : system_.neighbours(1.0 / scale_))
      report.closest.push_back({pair.a, pair.b, scale_ * portable::abs(pair.distance)});
    std::sort(report.closest.begin(), report.closest.end(),
              [](const ConeDistance& a, const ConeDistance& b) { return a.cells < b.cells; });
    report.closest.resize(std::min(report.closest.size(), kNamed));
    report.reason = formatText(
        "no choice of integers kept all triangles positive and all angles as asked at %.0f cells "
        "(%.1f "
        "per cone)%s",
        report.cells, report.cellsPerCone,
        isCutShort_ ? ", and looking further would have taken longer than the map itself" : "");
    // A program may have cost more than expected: what was kept for this is still there, and in any
    // case as much as linear steps cost where there are few integers.
    const double plainStep = kStepWork * mesh_.faceCount() + system_.solveWork();
    work_ = std::max({work_, reserved_, 1.5 * kDenser * plainStep});
    reserved_ = 0.0;
    double factor = 1.0;
    for (int n = 0; n < kDenser && affords(stepWork()); ++n) {
      factor *= std::sqrt(2.0);
      if (!goOn(0.9)) return;
      const Candidate denser = linearStep(system_.choice(2.0 * kReach / (scale_ * factor)), factor);
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
  const std::function<bool(const UvMap&)>& accepts_;
  const double repairWork_;  ///< multiply-adds that repairs have in any case
  double scale_ = 1.0;
  double work_, reserved_ = 0.0;  ///< multiply-adds left, and those of them kept for explain()
  bool isCutShort_ = false;
  AlignedMap out_;
};

}  // namespace

double surfaceArea(const TriMesh& mesh) {
  double area = 0.0;
  for (FaceId f : mesh.faces()) {
    const auto [i, j, k] = mesh.corners(f);
    area += triangleArea(mesh.position(i), mesh.position(j), mesh.position(k));
  }
  return area;
}

void describeGrid(const TriMesh& mesh, const UvMap& map, std::size_t coneCount,
                  GridReport& report) {
  report.cells = areaOf(map);
  report.spacing = std::sqrt(surfaceArea(mesh) / report.cells);
  report.cellsPerCone = report.cells / std::max<double>(1.0, static_cast<double>(coneCount));
}

AlignedMap alignToGrid(const TriMesh& mesh, const UvMap& map, int q,
                       const std::vector<VertexId>& cones, const GridOptions& options,
                       const linalg::SeparatorTree* tree, const Progress& progress, double work,
                       const std::function<bool(const UvMap&)>& accepts) {
  AlignedMap failed;
  if (q != 2 && q != 4) {
    failed.report.reason = formatText("a grid of squares needs q = 2 or 4, not %d", q);
    return failed;
  }
  const std::unique_ptr<GridSystem> system =
      GridSystem::make(mesh, map, q, cones, options.mode, tree);
  if (!system) {
    failed.report.reason = "the map's seams could not be read, or its strain is singular";
    return failed;
  }
  return Aligner(mesh, map, *system, cones, options, progress, work, accepts).run();
}

}  // namespace hgp
