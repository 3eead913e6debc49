// distortion DIR | --generated N: how far maps are from angle and area preserving, as solved, improved, and
// as others improve them on the same cut; or with other choices of cones (--cones).

#include <fnmatch.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>

#include "child_process.h"
#include "distortion_table.h"
#include "files.h"
#include "grid_run.h"
#include "hgp/api/load_model.h"
#include "hgp/base/check.h"
#include "process_memory.h"
#include "surfaces.h"

namespace hgp::bench {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  std::string folder, json, markdown;
  std::vector<std::string> only, skip;
  std::vector<int> q{4};
  int generated = 0, smallest = 0, largest = 0;
  std::uint64_t seed = 1;
  bool isAboutCones = false, isAboutGrids = false;
  DistortionOptions run;
  double cpuSeconds = 600.0;
};

bool matchesOneOf(const std::vector<std::string>& globs, const std::string& name) {
  return std::any_of(globs.begin(), globs.end(), [&](const std::string& g) {
    return fnmatch(g.c_str(), name.c_str(), 0) == 0;
  });
}

class Runner {
 public:
  explicit Runner(const Arguments& a) : a_(a), table_(distortionHead()) {
    std::fputs(table_.c_str(), stdout);
  }

  /// Every order, each in a process of its own.
  void run(const std::string& name, const TriMesh& mesh) {
    if (mesh.faceCount() < a_.smallest) return;
    if (a_.largest > 0 && mesh.faceCount() > a_.largest) return;
    for (const int q : a_.q) {
      DistortionOptions options = a_.run;
      options.q = q;
      const auto work = [&] {
        if (a_.isAboutCones) return toJson(compareCones(name, mesh, q));
        if (a_.isAboutGrids) return toJson(compareGrids(name, mesh, q));
        return toJson(compareMaps(name, mesh, options));
      };
      const Result<std::string> text = runInChild(work, {0.0, a_.cpuSeconds});
      DistortionRow row;
      if (text) {
        row = distortionRowFromJson(*text);
      } else {
        row.name = name;
        row.q = q;
        row.triangles = mesh.faceCount();
        row.failure = text.error().message;
      }
      const std::string lines = distortionLines(row);
      table_ += lines;
      std::fputs(lines.c_str(), stdout);
      std::fflush(stdout);
      rows_.push_back(std::move(row));
    }
  }

  bool finish() const {
    const std::string sums = a_.isAboutCones   ? coneSummary(rows_)
                             : a_.isAboutGrids ? gridSummary(rows_)
                                               : improvementSummary(rows_) + "\n" + counts();
    std::fputs(("\n" + sums).c_str(), stdout);
    return save(a_.json, toJson(rows_)) && save(a_.markdown, sums + "\n" + table_);
  }

 private:
  std::string counts() const {
    int plain = 0, improved = 0, asked = 0;
    for (const DistortionRow& row : rows_)
      for (const MeasuredMap& map : row.maps) {
        if (map.name == kPlain) plain += map.isCertified;
        if (map.name == kIsometric || map.name == kConformal) ++asked, improved += map.isCertified;
      }
    return formatText("%zu surfaces and orders: %d plain maps certified, %d of %d improved ones.\n",
                      rows_.size(), plain, improved, asked);
  }
  static bool save(const std::string& path, const std::string& text) {
    const Status saved = path.empty() ? Status(Done{}) : cli::writeText(path, text);
    if (!saved) std::fprintf(stderr, "distortion: %s\n", saved.error().message.c_str());
    return saved.hasValue();
  }

  const Arguments& a_;
  std::string table_;
  std::vector<DistortionRow> rows_;
};

/// Smallest file first, every connected component by itself; what is refused is none of this program's
/// business.
void runFolder(const Arguments& a, Runner& runner) {
  std::vector<std::pair<std::uintmax_t, fs::path>> files;
  for (const auto& entry : fs::recursive_directory_iterator(a.folder)) {
    const std::string name = entry.path().lexically_relative(a.folder).generic_string();
    if (!entry.is_regular_file() || (!a.only.empty() && !matchesOneOf(a.only, name))) continue;
    if (!matchesOneOf(a.skip, name)) files.emplace_back(entry.file_size(), entry.path());
  }
  std::sort(files.begin(), files.end());
  for (const auto& [size, file] : files) {
    api::LoadOptions load;
    Result<io::FileSet> set = cli::openFiles(file.string(), "", "", load.limits.maxBytes);
    if (!set) continue;
    const Result<api::Model> model = api::loadModel(std::move(*set), load);
    if (!model || model->unusable) continue;
    const std::string name = file.lexically_relative(a.folder).generic_string();
    for (std::size_t i = 0; i < model->components.size(); ++i)
      runner.run(model->components.size() > 1 ? formatText("%s #%zu", name.c_str(), i) : name,
                 model->components[i].mesh);
  }
}

/// Every genus to 6, closed and with holes, as bench/stress draws them.
void runGenerated(const Arguments& a, Runner& runner) {
  for (int n = 0; n < a.generated; ++n) {
    const std::string name = formatText("surface %d", n);
    const std::string seeded =
        formatText("%llu/%s", static_cast<unsigned long long>(a.seed), name.c_str());
    if (!a.only.empty() && !matchesOneOf(a.only, name)) continue;
    const auto mesh = buildTriMesh(stress::randomSurface(seeded, n % 7, n / 7 % 3));
    if (mesh) runner.run(seeded, *mesh);
  }
}

int runProgram(int argc, char** argv) {
  Arguments a;
  bool isOursAlone = false;
  CLI::App app("Distortion of maps, improved and compared, as a table.", "distortion");
  app.add_option("dir", a.folder, "folder of meshes");
  app.add_option("--generated", a.generated, "so many surfaces from a seed instead");
  app.add_option("--seed", a.seed, "of --generated");
  app.add_option("--q", a.q, "orders")->check(CLI::Range(1, 64));
  app.add_flag("--cones", a.isAboutCones, "compare choices of cones");
  app.add_flag("--grids", a.isAboutGrids, "align to grids (q = 2, 4)");
  app.add_flag("--ours", isOursAlone, "no comparators");
  app.add_option("--only", a.only, "names to take, as a pattern: '*torus*'");
  app.add_option("--skip", a.skip, "names to leave out");
  app.add_option("--smallest", a.smallest, "leave out surfaces of fewer triangles");
  app.add_option("--largest", a.largest, "leave out surfaces of more triangles");
  app.add_option("--slim-seconds", a.run.slimSeconds, "processor time of each SLIM");
  app.add_option("--time-limit", a.cpuSeconds, "processor time of a surface");
  app.add_option("--json", a.json, "also write the rows as JSON");
  app.add_option("--markdown", a.markdown, "also write the tables");
  CLI11_PARSE(app, argc, argv);
  a.run.hasComparators = !isOursAlone;
  std::error_code error;
  if (a.generated == 0 && !fs::is_directory(a.folder, error)) {
    std::fprintf(stderr, "distortion: name a folder of meshes, or --generated N\n");
    return 2;
  }
  Runner runner(a);
  if (a.generated > 0) {
    runGenerated(a, runner);
  } else {
    runFolder(a, runner);
  }
  return runner.finish() ? 0 : 7;
}

}  // namespace
}  // namespace hgp::bench

int main(int argc, char** argv) {
  hgp::cli::keepFreedMemory();
  try {
    return hgp::bench::runProgram(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "distortion: %s\n", error.what());
    return 70;
  }
}
