#include "grid_run.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "hgp/base/check.h"
#include "hgp/base/phrase.h"
#include "hgp/field/prepared_surface.h"
#include "hgp/grid/grid_measures.h"
#include "hgp/parametrize/parametrize.h"
#include "processor_time.h"

namespace hgp::bench {
namespace {

MeasuredMap measured(const std::string& name, const DistortionFacts& facts, bool isCertified) {
  MeasuredMap map;
  map.name = name;
  map.isCertified = isCertified;
  map.meanMu = facts.meanMu;
  map.p95Mu = facts.p95Mu;
  map.sigma = facts.rmsLogArea;
  map.excess = facts.symmetricDirichlet;
  return map;
}

class GridComparison {
 public:
  GridComparison(const TriMesh& mesh, SurfaceRow& row) : mesh_(mesh), row_(row) {
    const PreparedSurface surface(mesh);
    row.genus = surface.topology().genus;
    row.loops = static_cast<int>(surface.topology().loops.size());
  }

  /// Measures the map without a grid; false if there is nothing to align.
  bool plain(const char* kind) {
    const std::optional<Parametrization> run = solve(kind, nullptr);
    if (!run || !run->isCertified) return false;
    coneCount_ = static_cast<int>(run->spec.cones.size());
    add(bench::measured(kind, run->certificate), *run);
    return true;
  }

  void aligned(const char* kind, const AskedGrid& grid) {
    const std::optional<Parametrization> run = solve(kind, &grid);
    if (!run) return;
    const bool isAligned = run->grid && run->grid->isAligned;
    MeasuredMap last = bench::measured(alignedName(kind, grid), run->certificate);
    if (!isAligned) {
      last.note = run->grid && run->grid->reason ? phrase(*run->grid->reason) : "not certified";
      last.isCertified = false;
      add(last, *run);
      return;
    }
    if (run->improvement && run->improvement->onGrid) {
      const DescentFacts& descent = *run->improvement->onGrid;
      add(measured(last.name, descent.before, true), *run);
      last.name = descendedName(kind, grid);
      last.steps = static_cast<int>(descent.steps.size());
      last.note = outcomeName(descent.outcome);
      if (!descent.isKept) last.note += ", not kept";
    }
    add(last, *run);
  }

 private:
  std::optional<Parametrization> solve(const char* kind, const AskedGrid* grid) {
    SuggestOptions suggest;
    suggest.q = row_.q;
    ParametrizeOptions options;
    if (std::string_view(kind) != kPlain)
      options.improve.emplace().balance = std::string_view(kind) == kConformal ? -1.0 : 0.0;
    if (grid) {
      options.grid.cells = grid->perCone * std::max(1, coneCount_);
      options.grid.mode = grid->isQuad ? GridMode::kQuad : GridMode::kTile;
      suggest.spacing = roomForGrid(std::sqrt(surfaceArea(mesh_) / options.grid.cells),
                                    options.grid.mode, row_.q);
    }
    const double start = processorSeconds();
    PreparedSurface surface(mesh_);
    const Result<CompleteSpec> spec = suggestCones(surface, suggest);
    if (!spec) return {};
    Result<Parametrization> run = parametrize(surface, toSpec(*spec), options);
    seconds_ = processorSeconds() - start;
    if (!run) return {};
    return std::move(*run);
  }

  void add(MeasuredMap map, const Parametrization& run) {
    map.seconds = seconds_;
    map.cones = static_cast<int>(run.spec.cones.size());
    row_.maps.push_back(std::move(map));
  }

  const TriMesh& mesh_;
  SurfaceRow& row_;
  int coneCount_ = 0;
  double seconds_ = 0.0;
};

/// A table row with quantiles of one column.
std::string quantiles(const std::string& label, std::vector<double> values) {
  if (values.empty()) return "| " + label + " | 0 | | | | | |\n";
  std::sort(values.begin(), values.end());
  const auto share = [&](double s) {
    return values[static_cast<std::size_t>(s * static_cast<double>(values.size() - 1))];
  };
  return formatText("| %s | %zu | %.4f | %.4f | **%.4f** | %.4f | %.4f |\n", label.c_str(),
                    values.size(), values.front(), share(0.25), share(0.5), share(0.75),
                    values.back());
}

/// Compares one map of every row with that of the run without a grid.
class AgainstPlain {
 public:
  AgainstPlain(const std::vector<SurfaceRow>& rows, const char* kind, const std::string& name)
      : name_(name) {
    for (const SurfaceRow& row : rows) {
      const MeasuredMap *map = row.find(name), *plain = row.find(kind);
      if (!map || !plain) continue;
      ++runs_;
      if (!map->isCertified) continue;
      rises_.push_back(map->meanMu - plain->meanMu);
      if (plain->excess > 1e-3) excesses_.push_back(map->excess / plain->excess);
      if (plain->seconds > 0.0) times_.push_back(map->seconds / plain->seconds - 1.0);
    }
  }
  std::string text() const {
    if (runs_ == 0) return "";
    const std::string aligned = formatText(" (%zu of %d)", rises_.size(), runs_);
    return quantiles("mean μ rises, " + name_ + aligned, rises_) +
           quantiles("excess, ratio, " + name_, excesses_) +
           quantiles("time added, " + name_, times_);
  }

 private:
  std::string name_;
  int runs_ = 0;
  std::vector<double> rises_, excesses_, times_;
};

}  // namespace

std::string alignedName(const char* kind, const AskedGrid& grid) {
  return std::string(kind) + ", " + grid.name;
}
std::string descendedName(const char* kind, const AskedGrid& grid) {
  return alignedName(kind, grid) + ", descended";
}

SurfaceRow compareGrids(const std::string& name, const TriMesh& mesh, int q) {
  SurfaceRow row;
  row.name = name;
  row.triangles = mesh.faceCount();
  row.q = q;
  GridComparison comparison(mesh, row);
  for (const char* kind : kGridKinds) {
    if (!comparison.plain(kind)) break;
    for (const AskedGrid& grid : kAskedGrids) comparison.aligned(kind, grid);
  }
  return row;
}

std::string gridSummary(const std::vector<SurfaceRow>& rows) {
  std::string text =
      "| against the same without a grid | surfaces | least | 25 % | median | 75 % | most |\n"
      "|---|--:|--:|--:|--:|--:|--:|\n";
  for (const char* kind : kGridKinds)
    for (const AskedGrid& grid : kAskedGrids) {
      text += AgainstPlain(rows, kind, alignedName(kind, grid)).text();
      text += AgainstPlain(rows, kind, descendedName(kind, grid)).text();
    }
  return text;
}

}  // namespace hgp::bench
