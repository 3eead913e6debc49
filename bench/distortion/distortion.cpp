// distortion DIR | --generated N: how far maps are from angle and area preserving, as solved, improved, and
// as others improve them on the same cut; or with other choices of cones (--cones).

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "distortion_run.h"
#include "distortion_table.h"
#include "grid_run.h"
#include "hgp/base/check.h"
#include "process_memory.h"
#include "program.h"
#include "surface_selection.h"
#include "surface_table.h"

namespace hgp::bench {
namespace {

struct Arguments {
  SurfaceSelection surfaces;
  std::string json, markdown;
  std::vector<int> q{4};
  bool isAboutCones = false, isAboutGrids = false;
  DistortionOptions run;
  double cpuSeconds = 600.0;
};

std::string counts(const std::vector<SurfaceRow>& rows) {
  int plain = 0, improved = 0, asked = 0;
  for (const SurfaceRow& row : rows)
    for (const MeasuredMap& map : row.maps) {
      if (map.name == kPlain) plain += map.isCertified;
      if (map.name == kIsometric || map.name == kConformal) ++asked, improved += map.isCertified;
    }
  return formatText("%zu surfaces and orders: %d plain maps certified, %d of %d improved ones.\n",
                    rows.size(), plain, improved, asked);
}

/// Every order, each in a process of its own.
void addSurface(const Arguments& a, const std::string& name, const TriMesh& mesh,
                SurfaceTable& table) {
  for (const int q : a.q) {
    SurfaceRow blank;
    blank.name = name;
    blank.q = q;
    blank.triangles = mesh.faceCount();
    DistortionOptions options = a.run;
    options.q = q;
    table.add(std::move(blank), [&] {
      if (a.isAboutCones) return compareCones(name, mesh, q);
      if (a.isAboutGrids) return compareGrids(name, mesh, q);
      return compareMaps(name, mesh, options);
    });
  }
}

int runProgram(int argc, char** argv) {
  Arguments a;
  bool isOursAlone = false;
  CLI::App app("Distortion of maps, improved and compared, as a table.", "distortion");
  a.surfaces.addOptions(app);
  app.add_option("--q", a.q, "orders")->check(CLI::Range(1, 64));
  app.add_flag("--cones", a.isAboutCones, "compare choices of cones");
  app.add_flag("--grids", a.isAboutGrids, "align to grids (q = 2, 4)");
  app.add_flag("--ours", isOursAlone, "no comparators");
  app.add_option("--slim-seconds", a.run.slimSeconds, "processor time of each SLIM");
  app.add_option("--time-limit", a.cpuSeconds, "processor time of a surface");
  app.add_option("--json", a.json, "also write the rows as JSON");
  app.add_option("--markdown", a.markdown, "also write the tables");
  CLI11_PARSE(app, argc, argv);
  a.run.hasComparators = !isOursAlone;
  if (!a.surfaces.isUsable()) {
    std::fprintf(stderr, "distortion: name a folder of meshes, or --generated N\n");
    return 2;
  }
  SurfaceTable table(distortionHead(), distortionLines, a.cpuSeconds);
  eachSurface(a.surfaces, [&](const std::string& name, const TriMesh& mesh) {
    addSurface(a, name, mesh, table);
  });
  const std::vector<SurfaceRow>& rows = table.rows();
  const std::string sums = a.isAboutCones   ? coneSummary(rows)
                           : a.isAboutGrids ? gridSummary(rows)
                                            : improvementSummary(rows) + "\n" + counts(rows);
  std::fputs(("\n" + sums).c_str(), stdout);
  const bool isSaved = saveText("distortion", a.json, toJson(rows, "hgp-distortion"));
  return saveText("distortion", a.markdown, sums + "\n" + table.text()) && isSaved ? 0 : 7;
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
