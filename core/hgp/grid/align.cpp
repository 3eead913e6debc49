#include "hgp/grid/align.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/check.h"
#include "hgp/grid/grid_system.h"
#include "hgp/grid/mend_change.h"

namespace hgp {
namespace {

/// Densities tried by the linear step, as factors of the edge length.
constexpr double kFactors[] = {1.0, 1.06, 0.94, 1.12, 1.19, 1.27, 1.35};
/// Of those that turned triangles over, so many are mended, best first.
constexpr std::size_t kMended = 4;
constexpr std::size_t kMendedAsWhole = 2;
constexpr int kPatchRings[] = {6, 24};
constexpr double kPatchShare = 0.35;
/// Programs on the whole mesh, at most so many triangles large, and their rounds of growth.
constexpr int kLargestWhole = 150'000;
constexpr int kWholeRounds = 4;
/// Cones within so many cells are kept apart.
constexpr double kReach = 3.0;
constexpr int kDenser = 8;  ///< doublings of the density that are tried to name one that works

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
          const std::vector<VertexId>& cones, const GridOptions& options, const Progress& progress)
      : mesh_(mesh),
        system_(system),
        cones_(cones),
        progress_(progress),
        context_{mesh, system.seams(), system.change(), system.uv(), system.weights()},
        mapArea_(areaOf(map)),
        surfaceArea_(surfaceArea(mesh)) {
    const double cells =
        options.cells > 0.0 ? options.cells : surfaceArea_ / (options.spacing * options.spacing);
    scale_ = std::sqrt(cells / mapArea_);
  }

  AlignedMap run() {
    out_.report.integers = system_.integerCount();
    describe(scale_);
    const IntegerChoice choice = system_.choice(2.0 * kReach / scale_);
    std::vector<Candidate> candidates;
    for (double factor : kFactors) {
      if (!report(progress_, {"align", 0.1})) return std::move(out_);
      candidates.push_back(linearStep(choice, factor));
      if (accept(candidates.back(), "linear step")) return std::move(out_);
    }
    std::stable_sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
      return a.turned.size() < b.turned.size();
    });
    candidates.resize(std::min(candidates.size(), kMended));
    for (Candidate& candidate : candidates)
      if (mendOnPatches(candidate)) return std::move(out_);
    candidates.resize(std::min(candidates.size(), kMendedAsWhole));
    for (Candidate& candidate : candidates)
      if (mendAsWhole(candidate)) return std::move(out_);
    explain(choice);
    return std::move(out_);
  }

 private:
  void describe(double scale) {
    out_.report.cells = mapArea_ * scale * scale;
    out_.report.spacing = std::sqrt(surfaceArea_ / mapArea_) / scale;
    out_.report.cellsPerCone =
        out_.report.cells / std::max<double>(1.0, static_cast<double>(cones_.size()));
  }

  Candidate linearStep(const IntegerChoice& choice, double factor) const {
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
    out_.report.isAligned = true;
    describe(candidate.scale);
    return true;
  }

  bool mendOnPatches(Candidate& candidate) {
    for (int rings : kPatchRings) {
      // Cones that were rounded onto each other fold on any patch.
      if (!candidate.isApart && rings > kPatchRings[0]) return false;
      if (!report(progress_, {"align", 0.5})) return false;
      const std::vector<FaceId> patch = facesAround(mesh_, candidate.turned, rings);
      if (static_cast<double>(patch.size()) > kPatchShare * mesh_.faceCount()) return false;
      Candidate mended = candidate;
      if (!mendChange(context_, patch, patch, system_.isHeld(), mended.x)) continue;
      mended.turned = turnedFaces(context_, mended.x);
      if (accept(mended, rings == kPatchRings[0] ? "patch of 6 rings" : "patch of 24 rings"))
        return true;
      if (mended.turned.size() < candidate.turned.size()) candidate = std::move(mended);
    }
    return false;
  }

  /// Everything but the integers; conditions around cones and wherever a triangle turned over.
  bool mendAsWhole(Candidate& candidate) {
    // Cones that were rounded onto each other fold whatever the program.
    if (mesh_.faceCount() > kLargestWhole || !candidate.isApart) return false;
    std::vector<FaceId> all;
    for (FaceId f : mesh_.faces()) all.push_back(f);
    std::vector<FaceId> bound = facesAround(mesh_, candidate.turned, 2);
    for (int round = 0; round < kWholeRounds; ++round) {
      if (!report(progress_, {"align", 0.7})) return false;
      Candidate mended = candidate;
      if (!mendChange(context_, all, bound, system_.isHeld(), mended.x)) {
        out_.report.attempts.push_back({"whole mesh, infeasible",
                                        candidate.factor * candidate.factor,
                                        static_cast<int>(candidate.turned.size())});
        return false;
      }
      mended.turned = turnedFaces(context_, mended.x);
      if (accept(mended, "whole mesh")) return true;
      const std::vector<FaceId> more = facesAround(mesh_, mended.turned, 2);
      bound.insert(bound.end(), more.begin(), more.end());
      std::sort(bound.begin(), bound.end());
      bound.erase(std::unique(bound.begin(), bound.end()), bound.end());
    }
    return false;
  }

  /// The closest cones by name, and the first denser grid on which the linear step succeeds.
  void explain(const IntegerChoice&) {
    std::vector<ConePair> pairs = system_.neighbours(1.0 / scale_);
    std::sort(pairs.begin(), pairs.end(), [](const ConePair& a, const ConePair& b) {
      return std::abs(a.distance) < std::abs(b.distance);
    });
    std::string& reason = out_.report.reason;
    reason = formatText(
        "no choice of integers kept all triangles positive at %.0f cells (%.1f per cone)",
        out_.report.cells, out_.report.cellsPerCone);
    for (std::size_t n = 0; n < pairs.size() && n < 3; ++n)
      reason += formatText("%s cones %d and %d are %.2f cells apart", n == 0 ? ":" : ",",
                           pairs[n].a.i, pairs[n].b.i, scale_ * std::abs(pairs[n].distance));
    double factor = 1.0;
    for (int n = 0; n < kDenser; ++n) {
      factor *= std::sqrt(2.0);
      if (!report(progress_, {"align", 0.9})) return;
      const Candidate denser = linearStep(system_.choice(2.0 * kReach / (scale_ * factor)), factor);
      if (!denser.turned.empty()) continue;
      out_.report.workingCells = mapArea_ * denser.scale * denser.scale;
      reason += formatText("; %.0f cells would work", out_.report.workingCells);
      return;
    }
  }

  const TriMesh& mesh_;
  const GridSystem& system_;
  const std::vector<VertexId>& cones_;
  const Progress& progress_;
  const ChangeContext context_;
  const double mapArea_, surfaceArea_;
  double scale_ = 1.0;
  AlignedMap out_;
};

}  // namespace

double surfaceArea(const TriMesh& mesh) {
  double area = 0.0;
  for (FaceId f : mesh.faces()) {
    const auto [i, j, k] = mesh.corners(f);
    const Vec3 &p = mesh.position(i), &q = mesh.position(j), &r = mesh.position(k);
    const Vec3 u{q[0] - p[0], q[1] - p[1], q[2] - p[2]}, v{r[0] - p[0], r[1] - p[1], r[2] - p[2]};
    area += 0.5 * std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                             u[0] * v[1] - u[1] * v[0]);
  }
  return area;
}

AlignedMap alignToGrid(const TriMesh& mesh, const UvMap& map, int q,
                       const std::vector<VertexId>& cones, const GridOptions& options,
                       const linalg::SeparatorTree* tree, const Progress& progress) {
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
  return Aligner(mesh, map, *system, cones, options, progress).run();
}

}  // namespace hgp
