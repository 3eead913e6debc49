// compare DIR | --generated N: maps with the same cones by our methods, by the programs that they come from, by a
// harmonic map without frames and by a discrete conformal metric, each judged by the verifier.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "method_table.h"
#include "methods.h"
#include "process_memory.h"
#include "program.h"
#include "surface_selection.h"
#include "surface_table.h"

namespace hgp::bench {
namespace {

int runProgram(int argc, char** argv) {
  SurfaceSelection surfaces;
  CompareOptions options;
  std::vector<std::string> choices{"balanced"};
  std::string json, markdown;
  double cpuSeconds = 600.0;
  CLI::App app("Methods beside each other, as a table.", "compare");
  surfaces.addOptions(app);
  app.add_option("--cones", choices,
                 "balanced, few, low-distortion, field, orbifold, random, handles, …")
      ->check([](const std::string& choice) {
        return isChoice(choice) ? std::string() : "no choice of cones: " + choice;
      });
  app.add_option("--q", options.q, "order of chosen cones")->check(CLI::Range(1, 64));
  app.add_option("--method-seconds", options.methodSeconds, "processor time of each method");
  app.add_option("--time-limit", cpuSeconds, "processor time of a surface");
  app.add_option("--json", json, "also write the rows as JSON");
  app.add_option("--markdown", markdown, "also write the tables");
  CLI11_PARSE(app, argc, argv);
  if (!surfaces.isUsable()) {
    std::fprintf(stderr, "compare: name a folder of meshes, or --generated N\n");
    return 2;
  }
  options.seed = surfaces.seed;
  SurfaceTable table(methodHead(), methodLines, cpuSeconds);
  eachSurface(surfaces, [&](const std::string& name, const TriMesh& mesh) {
    for (const std::string& choice : choices) {
      SurfaceRow blank;
      blank.name = name;
      blank.choice = choice;
      blank.triangles = mesh.faceCount();
      table.add(blank, [&] { return compareMethods(name, mesh, choice, options); });
    }
  });
  const std::string sums = methodSummary(table.rows());
  std::fputs(("\n" + sums).c_str(), stdout);
  const bool isSaved = saveText("compare", json, toJson(table.rows(), "hgp-compare"));
  return saveText("compare", markdown, sums + "\n" + table.text()) && isSaved ? 0 : 7;
}

}  // namespace
}  // namespace hgp::bench

int main(int argc, char** argv) {
  hgp::cli::keepFreedMemory();
  try {
    return hgp::bench::runProgram(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "compare: %s\n", error.what());
    return 70;
  }
}
