// distortion DIR | --generated N: the distortion of angles and areas of maps as solved, as improved, and as improved by
// other methods on the same cut; or for different choices of cones (--cones).

#include "distortion_run.h"
#include "distortion_table.h"
#include "grid_run.h"
#include "hgp/base/check.h"
#include "table_program.h"

namespace hgp::bench {
namespace {

struct Arguments {
  TableProgram program{"distortion", {}, {}, {}};
  std::vector<int> q{4};
  bool isAboutCones = false, isAboutGrids = false;
  DistortionOptions run;
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

/// Measures a surface for every order q, each in a separate process.
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
  CLI::App app("Distortion of maps, improved and compared, as a table.", a.program.name);
  a.program.addOptions(app);
  app.add_option("--q", a.q, "orders")->check(CLI::Range(1, 64));
  app.add_flag("--cones", a.isAboutCones, "compare choices of cones");
  app.add_flag("--grids", a.isAboutGrids, "align to grids (q = 2, 4)");
  app.add_flag("--ours", isOursAlone, "no comparators");
  app.add_option("--slim-seconds", a.run.slimSeconds, "processor time of each SLIM");
  CLI11_PARSE(app, argc, argv);
  a.run.hasComparators = !isOursAlone;
  if (!a.program.isUsable()) return 2;
  SurfaceTable table(distortionHead(), distortionLines, a.program.cpuSeconds);
  eachSurface(a.program.surfaces, [&](const std::string& name, const TriMesh& mesh) {
    addSurface(a, name, mesh, table);
  });
  const std::vector<SurfaceRow>& rows = table.rows();
  return a.program.finish(a.isAboutCones   ? coneSummary(rows)
                          : a.isAboutGrids ? gridSummary(rows)
                                           : improvementSummary(rows) + "\n" + counts(rows),
                          table);
}

}  // namespace
}  // namespace hgp::bench

int main(int argc, char** argv) {
  return hgp::bench::runTableProgram("distortion", hgp::bench::runProgram, argc, argv);
}
